// The error of a difference of two means, each of which was estimated with an error of its own.
#pragma once

#include "core/math.h"

namespace umbral {

// σ_a T_a + σ_b T_b, where T_i is Student's with ν_i degrees of freedom, independent [Behrens 1929, Fisher 1935].
//
// What Welch's t does instead – one Student's t with degrees of freedom after [Satterthwaite 1946] – does not keep its level
// far out in the tails when a side has few replicates: two that happen to agree look exact, and at 5 · 10⁻⁶ false alarms
// become thousands of times as frequent as promised. This one never exceeds its level [Robinson 1976; our test].
struct BehrensFisher {
  double variance_a = 0, dof_a = infinity;  // of a known side 0 and infinite
  double variance_b = 0, dof_b = infinity;

  double standard_error() const;  // √(σ_a² + σ_b²)

  // P(|error| ≥ distance), distance ≥ 0. 1 − [distance > 0] where there is no error.
  double two_sided_p(double distance) const;

  // The distance within which the error stays with that probability, in (0, 1).
  double half_width(double confidence) const;
};

}  // namespace umbral
