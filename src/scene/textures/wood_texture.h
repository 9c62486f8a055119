// Wood: rings around z, and grain along it.
#pragma once

#include <tuple>

#include "scene/textures/noise_place.h"

namespace umbral {

// Year rings: from spring wood (low) to summer wood (high) as r grows by 1, then sharply back.
struct WoodTexture : NoisePlace {
  float wobble = 0.3f;
  float grain = 0.2f;

  static constexpr const char* kind = "wood";
  static constexpr const char* doc = "wood: rings around the z axis (or the uv origin), and grain along it";
  static constexpr auto parameters = std::tuple_cat(
      detail::place_parameters<WoodTexture>("colour of spring wood", "colour of summer wood",
                                            "rings per unit"),
      std::tuple{
          parameter<&WoodTexture::wobble>("wobble", "by how many rings they leave the circle", non_negative),
          parameter<&WoodTexture::grain>("grain", "how much fine fibres show", zero_to_one)});

  static void prepare() {}
  Spectrum evaluate(const TexturePoint& point) const;
  TextureStep step() const { return step_of(0.05f); }
};

}  // namespace umbral
