// Means of replicates, and the difference of two.
#include "analysis/estimate.h"

#include "core/statistics.h"

namespace umbral {

MeanEstimate mean_of(std::span<const double> replicates) {
  Moments moments;
  for (const double value : replicates) moments.add(value);
  const auto n = static_cast<double>(moments.n);
  MeanEstimate estimate{moments.mean};
  if (moments.n < 2) return estimate;
  estimate.variance = moments.variance() / n;
  estimate.degrees_of_freedom = n - 1;
  if (!(moments.m2 > 0)) return estimate;
  const double sigma = std::sqrt(moments.m2 / n);
  for (const double value : replicates) estimate.skewness += std::pow((value - moments.mean) / sigma, 3) / n;
  return estimate;
}

Difference difference(const MeanEstimate& a, const MeanEstimate& b) {
  return {b.value - a.value,
          {a.variance, a.degrees_of_freedom, b.variance, b.degrees_of_freedom},
          std::abs(a.skewness) > std::abs(b.skewness) ? a.skewness : b.skewness};
}

}  // namespace umbral
