// Mip levels: an image at half, a quarter, … of its size.
#pragma once

#include <vector>

#include "image/texture_image.h"

namespace umbral {

// From half the size down to one texel, in the format of `finest`; each texel is the mean, in linear light, of the texels
// of the level above that it covers (in part, where sides are odd), so that all levels have the same mean.
std::vector<TextureImage::Texels> mip_levels(const TextureImage::Texels& finest);

}  // namespace umbral
