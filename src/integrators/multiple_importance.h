// Weights of multiple importance sampling.
#pragma once

#include "core/math.h"

namespace umbral {

// The power heuristic with β = 2 [Veach 1997, §9.2]: w = p²/(p² + q²) for a sample that was drawn with the density p and
// could have been drawn with q; both finite, ≥ 0. Written so that no square of a density overflows.
inline float power_heuristic(float p, float q) {
  if (!(p > 0)) return 0;
  return 1 / (1 + sqr(q / p));
}

}  // namespace umbral
