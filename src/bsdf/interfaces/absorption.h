// What a clear body takes from light on its way through it.
#pragma once

#include <limits>

#include "core/spectrum.h"

namespace umbral {

// Beer and Lambert's law: of the light that goes a way d through it, exp(−σ d) is left [Lambert 1760].
struct Absorption {
  Spectrum sigma = black;  // per unit of length, world

  // With which `color` is left after `distance` (> 0, may be infinite); less than 1e-30 counts as that.
  static Absorption of_color(const Spectrum& color, float distance) {
    if (std::isinf(distance)) return {};
    return {-glm::log(glm::max(color, rgb(1e-30f, 1e-30f, 1e-30f) + Spectrum(0, 0, 0, 1))) / distance};
  }

  bool absorbs() const { return !is_black(sigma); }
  Spectrum transmittance(float distance) const {
    return glm::exp(-sigma * std::min(distance, std::numeric_limits<float>::max())) * white;
  }
};

}  // namespace umbral
