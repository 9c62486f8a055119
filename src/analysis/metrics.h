// Metrics of the difference between an image and its reference: one definition each.
#pragma once

#include <string>
#include <vector>

#include "analysis/estimated_image.h"

namespace umbral {

// With d = b − a, where a is the reference, as means over all pixels and channels:
//   MSE     d²
//   relMSE  d²/(a² + 0.01)
//   MRSE    d²/(|a| + 0.01)²
//   MAPE    |d|/(|a| + 0.01)
//   SMAPE   |d|/(|a| + |b| + 0.01)
struct Metric {
  const char* name;
  const char* definition;
  double value = 0;
  // Without what the noise of the reference adds, so that it is the error of b alone: d² − v_a in place of d² (to
  // first order, where the reference divides too). NaN where the error of a is unknown and for |d|, for which there is
  // no such estimate.
  double debiased = 0;
  // What is expected of two images with equal means and this noise, taken as normal; NaN where an error is unknown.
  double of_noise = 0;
};

std::vector<Metric> metrics(const EstimatedImage& reference, const EstimatedImage& image);

}  // namespace umbral
