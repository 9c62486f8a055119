// Planes: an image of linear RGB, one plane a channel.
#pragma once

#include <array>
#include <vector>

#include "core/math.h"

namespace umbral {

// Row by row from the top; every channel has width · height values, or none if the planes are empty.
struct Planes {
  int width = 0, height = 0;
  std::array<std::vector<float>, 3> channels;

  Planes() = default;
  Planes(int w, int h) : width(w), height(h) {
    for (std::vector<float>& channel : channels) channel.resize(pixels());
  }

  bool empty() const { return width == 0; }
  std::size_t pixels() const { return static_cast<std::size_t>(width) * static_cast<std::size_t>(height); }
  Vec3d at(std::size_t i) const { return {channels[0][i], channels[1][i], channels[2][i]}; }
  Vec3d at(int x, int y) const {
    return at(static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x));
  }
};

}  // namespace umbral
