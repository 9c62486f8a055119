// Means of replicates, and Welch's difference of two.
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

// ν = (V_a + V_b)² / (V_a²/ν_a + V_b²/ν_b)
MeanEstimate difference(const MeanEstimate& a, const MeanEstimate& b) {
  const double spread = sqr(a.variance) / a.degrees_of_freedom + sqr(b.variance) / b.degrees_of_freedom;
  MeanEstimate d;
  d.value = b.value - a.value;
  d.variance = a.variance + b.variance;
  d.degrees_of_freedom =
      spread > 0 ? sqr(d.variance) / spread : std::min(a.degrees_of_freedom, b.degrees_of_freedom);
  d.skewness = std::abs(a.skewness) > std::abs(b.skewness) ? a.skewness : b.skewness;
  return d;
}

}  // namespace umbral
