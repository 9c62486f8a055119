// Sums over pairs of images.
#include "analysis/replicate_products.h"

#include "core/parallel.h"

namespace umbral {

ReplicateProducts::ReplicateProducts(std::span<const Planes> replicates, const Planes& origin)
    : count_(replicates.size()), products_(count_ * count_) {
  const Planes& zero = origin.empty() ? replicates.front() : origin;
  parallel_for(count_, [&](std::size_t i) {
    for (std::size_t j = 0; j <= i; ++j) {
      double sum = 0;
      for (int c = 0; c < 3; ++c) {
        const std::vector<float>&a = replicates[i].channels[c], &b = replicates[j].channels[c];
        const std::vector<float>& o = zero.channels[c];
        for (std::size_t pixel = 0; pixel < o.size(); ++pixel)
          sum += (static_cast<double>(a[pixel]) - o[pixel]) * (static_cast<double>(b[pixel]) - o[pixel]);
      }
      products_[i * count_ + j] = products_[j * count_ + i] = sum / (3 * static_cast<double>(zero.pixels()));
    }
  });
}

double ReplicateProducts::variance_without(std::size_t left_out) const {
  double own = 0, other = 0;
  for (std::size_t i = 0; i < count_; ++i)
    for (std::size_t j = 0; j < count_; ++j)
      if (i != left_out && j != left_out) (i == j ? own : other) += at(i, j);
  const auto n = static_cast<double>(left_out < count_ ? count_ - 1 : count_);
  return own / n - other / (n * (n - 1));
}

double ReplicateProducts::error_without(std::size_t left_out, const ReferenceNoise& noise) const {
  double sum = 0;
  for (std::size_t i = 0; i < count_; ++i)
    if (i != left_out) sum += at(i, i);
  return sum / static_cast<double>(left_out < count_ ? count_ - 1 : count_) - noise.variance;
}

double ReplicateProducts::squared_bias(const ReferenceNoise& noise) const {
  return error(noise) - variance();
}

std::optional<LogEstimate> ReplicateProducts::log_variance() const {
  return jackknifed(count_, [this](std::size_t i) { return variance_without(i); });
}

std::optional<LogEstimate> ReplicateProducts::log_error(const ReferenceNoise& noise) const {
  auto result = jackknifed(count_, [&](std::size_t i) { return error_without(i, noise); });
  if (result) result->variance += noise.variance_of_mean_square / sqr(error(noise));
  return result;
}

}  // namespace umbral
