// ReplicateProducts: all that convergence asks of the replicates of an image, in R² numbers.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "analysis/log_estimate.h"
#include "analysis/planes.h"

namespace umbral {

/// Noise that a reference is known to have, averaged over pixels and channels.
struct ReferenceNoise {
  double variance = 0;                 // mean of its squared standard errors
  double variance_of_mean_square = 0;  // of the mean of its squared deviations from the truth
};

/// Inner products ⟨dᵢ, dⱼ⟩ = mean over pixels and channels of dᵢ dⱼ, where dᵢ is replicate i minus an origin common to
/// all. Variance does not depend on the origin; error and bias are about it.
class ReplicateProducts {
 public:
  /// Of R ≥ 2 images of the same size, about `origin`, or, where that is empty, about the first of them.
  ReplicateProducts(std::span<const Planes> replicates, const Planes& origin);

  std::size_t count() const { return count_; }
  double at(std::size_t i, std::size_t j) const { return products_[i * count_ + j]; }

  /// Mean over pixels and channels of the variance of one replicate, unbiased:
  ///   V = mean over i of ⟨dᵢ, dᵢ⟩ − mean over i ≠ j of ⟨dᵢ, dⱼ⟩
  double variance() const { return variance_without(count_); }
  /// Mean squared error of one replicate about a reference with that noise.
  double error(const ReferenceNoise& noise = {}) const { return error_without(count_, noise); }
  /// Bias², the mean over i ≠ j of ⟨dᵢ, dⱼ⟩, which is 0 on average where the mean of the replicates is the truth.
  double squared_bias(const ReferenceNoise& noise = {}) const;

  /// Their logarithms with error bars; nothing where noise leaves no positive number.
  std::optional<LogEstimate> log_variance() const;
  std::optional<LogEstimate> log_error(const ReferenceNoise& noise) const;

 private:
  double variance_without(std::size_t left_out) const;
  double error_without(std::size_t left_out, const ReferenceNoise& noise) const;

  std::size_t count_;
  std::vector<double> products_;  // row by row
};

}  // namespace umbral
