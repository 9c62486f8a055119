// The mean squared difference of two images' means, unbiased by the noise of either.
#pragma once

#include <optional>

#include "analysis/estimated_image.h"

namespace umbral {

struct SquaredBias {
  // Mean over pixels and channels of an unbiased estimate of (μ_b − μ_a)²; it may be below 0.
  double value = 0;
  // Of `value`, where the two images have the same mean; infinite if nothing is known about it.
  double standard_error = infinity;
  double degrees_of_freedom = 0;
};

// From replicates on both sides, or replicates and a truth: the mean of the products of two differences
// ⟨B_g − A_g, B_h − A_h⟩ over all pairs g ≠ h of groups of replicates. With no difference the products are
// uncorrelated with mean 0, so their spread is that of their mean [Chen and Qin 2010].
//
// From errors of pixels: the mean of (b − a)² − v_a − v_b, and its spread over pixels, which are independent.
//
// Nothing if an image's error is unknown, if one has replicates and the other errors of pixels, or if there are less
// than four groups.
std::optional<SquaredBias> squared_bias(const EstimatedImage& a, const EstimatedImage& b);

}  // namespace umbral
