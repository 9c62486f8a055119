// Building and inverting cumulative sums.
#include "core/distribution.h"

#include <algorithm>
#include <numeric>
#include <stdexcept>

namespace umbral {

namespace {

// Samplers draw multiples of 2⁻²⁴, and floats hold all of them: a table of such numbers is exact, and an index
// with less than a step might never be drawn.
constexpr double steps = 1 << 24;

// The cumulative sum of `weights` in steps, rounded, then moved so that every index with a weight has a step or more.
std::vector<double> cumulative_steps(std::span<const double> weights, double sum) {
  const std::size_t n = weights.size();
  std::vector<double> table(n + 1, 0.0);
  double running = 0;
  for (std::size_t i = 0; i < n; ++i) {
    running += weights[i];
    table[i + 1] = std::max(std::round(running / sum * steps), table[i] + (weights[i] > 0 ? 1 : 0));
  }
  table[n] = steps;
  for (std::size_t i = n; i-- > 1;)
    table[i] = weights[i] > 0 ? std::min(table[i], table[i + 1] - 1) : table[i + 1];
  return table;
}

}  // namespace

Distribution1D::Distribution1D(std::span<const double> weights) : cdf_(weights.size() + 1, 0.0f) {
  sum_ = std::accumulate(weights.begin(), weights.end(), 0.0);
  const std::vector<double> equal(sum_ > 0 ? 0 : weights.size(), 1.0);
  const std::span<const double> used = sum_ > 0 ? weights : equal;
  const auto drawn = std::count_if(used.begin(), used.end(), [](double weight) { return weight > 0; });
  if (static_cast<double>(drawn) > steps)
    throw std::length_error("a distribution over more than 2^24 weights: samples have not as many digits");
  const std::vector<double> table =
      cumulative_steps(used, sum_ > 0 ? sum_ : static_cast<double>(used.size()));
  std::transform(table.begin(), table.end(), cdf_.begin(),
                 [](double x) { return static_cast<float>(x / steps); });
}

Distribution1D::Draw Distribution1D::sample(float u) const {
  const auto above = std::upper_bound(cdf_.begin() + 1, cdf_.end() - 1, u);
  const auto index = static_cast<std::size_t>(above - cdf_.begin()) - 1;
  const float width = probability(index);
  const float remainder = width > 0 ? (u - cdf_[index]) / width : 0.5f;
  return {index, width, std::min(remainder, one_minus_epsilon)};
}

Distribution2D::Distribution2D(std::span<const double> weights, std::size_t width, std::size_t height) {
  std::vector<double> sums;
  for (std::size_t y = 0; y < height; ++y) {
    columns_.emplace_back(weights.subspan(y * width, width));
    sums.push_back(columns_.back().sum());
  }
  rows_ = Distribution1D(sums);
}

Distribution2D::Draw Distribution2D::sample(const Vec2& u) const {
  const Distribution1D::Draw row = rows_.sample(u.y);
  const Distribution1D::Draw column = columns_[row.index].sample(u.x);
  return {column.index, row.index, row.probability * column.probability, {column.remainder, row.remainder}};
}

}  // namespace umbral
