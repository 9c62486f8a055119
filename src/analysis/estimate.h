// MeanEstimate: a mean that was estimated, and how exactly.
#pragma once

#include <span>

#include "core/behrens_fisher.h"
#include "core/math.h"

namespace umbral {

struct MeanEstimate {
  double value = 0;
  double variance = 0;                   // of `value`; 0 if it is known exactly
  double degrees_of_freedom = infinity;  // behind `variance`
  double skewness = 0;                   // of the replicates; 0 if there are none to tell it from
};

// From independent replicates of the same thing; at least one, and a single one is taken for exact.
MeanEstimate mean_of(std::span<const double> replicates);

// b − a.
struct Difference {
  double value = 0;
  BehrensFisher error;
  double skewness = 0;  // the larger of the two
};

Difference difference(const MeanEstimate& a, const MeanEstimate& b);

}  // namespace umbral
