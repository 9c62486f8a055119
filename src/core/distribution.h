// Distributions over a list and over a grid, sampled by their stored cumulative sums.
#pragma once

#include <span>
#include <vector>

#include "core/math.h"

namespace umbral {

// Over 0 … size−1, each with the probability weight/sum to the nearest 2⁻²⁴, the step of the numbers that samplers draw,
// but a step at least where there is a weight, as estimates rely on it. Draws follow the told probabilities exactly.
class Distribution1D {
 public:
  struct Draw {
    std::size_t index;
    float probability;  // of this index
    float remainder;    // where in the index's interval u fell, in [0, 1): uniform again
  };

  Distribution1D() = default;
  // Weights are finite and ≥ 0, at most 2²⁴ (std::length_error) above 0; if all are 0, every index is as probable.
  explicit Distribution1D(std::span<const double> weights);

  std::size_t size() const { return cdf_.empty() ? 0 : cdf_.size() - 1; }
  double sum() const { return sum_; }  // of the weights
  Draw sample(float u) const;
  float probability(std::size_t index) const { return cdf_[index + 1] - cdf_[index]; }

 private:
  std::vector<float> cdf_;  // size + 1 values, from 0 to 1
  double sum_ = 0;
};

// Over the cells of a width × height grid: a row, then a column of it.
class Distribution2D {
 public:
  struct Draw {
    std::size_t x, y;
    float probability;  // of this cell
    Vec2 remainder;     // where in the cell's intervals u fell, in [0, 1)²: uniform again
  };

  Distribution2D() = default;
  // Row by row, as those of Distribution1D.
  Distribution2D(std::span<const double> weights, std::size_t width, std::size_t height);

  Draw sample(const Vec2& u) const;
  float probability(std::size_t x, std::size_t y) const {
    return rows_.probability(y) * columns_[y].probability(x);
  }
  double sum() const { return rows_.sum(); }

 private:
  Distribution1D rows_;
  std::vector<Distribution1D> columns_;  // one a row
};

}  // namespace umbral
