// Clouds: fractal noise between two colours.
#pragma once

#include <tuple>

#include "scene/textures/noise_place.h"

namespace umbral {

struct NoiseTexture : NoisePlace {
  int octaves = 6;
  float gain = 0.5f;

  static constexpr const char* kind = "noise";
  static constexpr const char* doc = "clouds: fractal noise between two colours";
  static constexpr auto parameters = std::tuple_cat(
      detail::place_parameters<NoiseTexture>("colour where the noise is lowest", "where it is highest",
                                             "coarse features per unit"),
      std::tuple{
          parameter<&NoiseTexture::octaves>("octaves", "sizes of features, each half the one before",
                                            Range{1, 16}),
          parameter<&NoiseTexture::gain>("gain", "height of each size, of the one before", zero_to_one)});

  static void prepare() {}
  Spectrum evaluate(const TexturePoint& point) const;
  TextureStep step() const { return step_of(std::exp2(static_cast<float>(1 - octaves))); }
};

}  // namespace umbral
