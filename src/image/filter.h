// Pixel reconstruction filters, importance-sampled so that every camera sample has weight 1.
#pragma once

#include <array>

#include "core/math.h"
#include "core/parameters.h"

namespace umbral {

enum class FilterKind { box, tent, gaussian };

template <>
struct EnumNames<FilterKind> {
  static constexpr std::array<const char*, 3> names{"box", "tent", "gaussian"};
};

// A separable, non-negative filter, zero beyond `radius` in x and in y and normalised to 1. The estimate of a
// pixel is the plain mean of radiance at positions drawn from it [Ernst et al. 2006].
//   box       constant                                             default radius 0.5
//   tent      1 − |x|/radius                                       default radius 1
//   gaussian  exp(−x²/2σ²) with σ = radius/3, cut off at 3σ        default radius 1.5, so that σ = 0.5
struct Filter {
  FilterKind kind = FilterKind::gaussian;
  float radius = 0;  // pixels, ≥ 0; 0 means the default of the kind

  // Pixels; never 0.
  float effective_radius() const;

  // Where to sample: the offset from the pixel's centre in pixels, from u in [0, 1)².
  Vec2 sample(const Vec2& u) const;

  // The density that sample() follows in one dimension, per pixel, at `x` pixels from the centre.
  double density(double x) const;
  // Its integral from −∞ to `x`.
  double cdf(double x) const;
};

}  // namespace umbral
