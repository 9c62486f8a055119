// Marble: veins across x, bent by noise.
#pragma once

#include <tuple>

#include "scene/textures/noise_place.h"

namespace umbral {

// The wave (1 + sin 2π(x + turbulence · noise))/2, sharpened [Perlin 1985].
struct MarbleTexture : NoisePlace {
  int octaves = 6;
  float turbulence = 1;
  float sharpness = 2;

  static constexpr const char* kind = "marble";
  static constexpr const char* doc = "marble: veins across x (or u), bent by noise";
  static constexpr auto parameters = std::tuple_cat(
      detail::place_parameters<MarbleTexture>("colour of the veins", "colour of the stone", "veins per unit"),
      std::tuple{parameter<&MarbleTexture::octaves>("octaves", "sizes of the noise, each half the one before",
                                                    Range{1, 16}),
                 parameter<&MarbleTexture::turbulence>("turbulence", "by how many veins they are bent",
                                                       non_negative),
                 parameter<&MarbleTexture::sharpness>("sharpness", "thins the veins; 1 is a sine",
                                                      Range{0.1f, 100})});

  static void prepare() {}
  Spectrum evaluate(const TexturePoint& point) const;
  TextureStep step() const { return step_of(std::exp2(static_cast<float>(1 - octaves))); }
};

}  // namespace umbral
