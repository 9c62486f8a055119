// Stone: cells of differing colour with joints between them.
#pragma once

#include <tuple>

#include "scene/textures/noise_place.h"

namespace umbral {

// Cells around random points, parted where the two nearest are almost equally far [Worley 1996].
struct StoneTexture : NoisePlace {
  Spectrum joint = grey(0.1f);
  float joint_width = 0.08f;

  static constexpr const char* kind = "stone";
  static constexpr const char* doc = "stone: cells of differing colour with joints between them";
  static constexpr auto parameters = std::tuple_cat(
      detail::place_parameters<StoneTexture>("a cell has a colour from this", "to this", "cells per unit"),
      std::tuple{parameter<&StoneTexture::joint>("joint", "colour between cells", non_negative),
                 parameter<&StoneTexture::joint_width>("joint_width", "in cells; 0 for none", zero_to_one)});

  static void prepare() {}
  Spectrum evaluate(const TexturePoint& point) const;
  TextureStep step() const { return step_of(std::clamp(joint_width, 0.02f, 1.0f)); }
  TextureBounds bounds() const {
    return {glm::min(glm::min(low, high), joint), glm::max(glm::max(low, high), joint)};
  }
};

}  // namespace umbral
