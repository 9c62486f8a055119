// GGX's alpha along u and along v, as files tell it, in umbral's terms.
#pragma once

#include <algorithm>

#include "core/parameters.h"
#include "scene/ids.h"

namespace umbral {

struct FacetWidths {
  float alpha_u = 0, alpha_v = 0;   // 0 … 1
  TextureId map = TextureId::none;  // of roughness, the square root of alpha, in the place of both

  bool is_textured() const { return map != TextureId::none; }
  // The square root of their geometric mean, for lobes that have one alone.
  Textured<float> roughness() const { return {std::sqrt(std::sqrt(alpha_u * alpha_v)), map}; }

  // alpha (1 ± anisotropy) along the direction of the wider ones and across it.
  template <class Lobe>  // a Conductor or a Dielectric
  void put_into(Lobe& lobe) const {
    const float mean = (alpha_u + alpha_v) / 2;
    lobe.roughness = std::sqrt(mean);
    lobe.anisotropy = mean > 0 ? std::abs(alpha_u - alpha_v) / (2 * mean) : 0;
    lobe.anisotropy_rotation = alpha_u < alpha_v ? 90 : 0;
  }
};

}  // namespace umbral
