// Replicates as the planes that statistics of images are made of.
#pragma once

#include "analysis/estimated_image.h"
#include "render/replicates.h"

namespace umbral {

/// Of an image of that size.
inline Planes planes_of(const ImageReplicate& replicate, int width, int height) {
  Planes planes(width, height);
  for (std::size_t i = 0; i < replicate.pixels.size(); ++i)
    for (int c = 0; c < 3; ++c) planes.channels[c][i] = static_cast<float>(replicate.pixels[i][c]);
  return planes;
}

}  // namespace umbral
