// Pearson's χ² test of counts against expectations, and the numbers that tests draw.
#pragma once

#include <cstdint>
#include <random>
#include <vector>

#include <boost/math/distributions/chi_squared.hpp>

#include "core/math.h"

namespace umbral::test {

// The probability of counts at least as far from `expected` as these. Cells that expect fewer than 5 are
// pooled; a cell that expects nothing must be empty.
inline double chi_square_p(const std::vector<double>& counts, const std::vector<double>& expected) {
  double statistic = 0, pooled_count = 0, pooled_expected = 0;
  int cells = 0;
  const auto add = [&](double count, double expectation) {
    statistic += sqr(count - expectation) / expectation;
    ++cells;
  };
  for (std::size_t i = 0; i < counts.size(); ++i) {
    if (expected[i] == 0 && counts[i] > 0) return 0;
    if (expected[i] >= 5) {
      add(counts[i], expected[i]);
    } else {
      pooled_count += counts[i];
      pooled_expected += expected[i];
    }
  }
  if (pooled_expected > 0) add(pooled_count, pooled_expected);
  if (cells < 2) return 1;
  return boost::math::cdf(boost::math::complement(boost::math::chi_squared(cells - 1), statistic));
}

// The p-value of points being uniform on the unit square, by 16 × 16 equal cells; points outside have p = 0.
class UniformSquareTest {
 public:
  void add(double x, double y) {
    constexpr double slack = 1e-5;  // what rounding may push over the edge
    if (!(x > -slack && x < 1 + slack && y > -slack && y < 1 + slack)) {
      ++outside_;
      return;
    }
    ++counts_[cell(x) + 16 * cell(y)];
    ++total_;
  }

  double p() const {
    if (outside_ > 0) return 0;
    return chi_square_p(counts_, std::vector<double>(256, total_ / 256));
  }

 private:
  static std::size_t cell(double x) { return static_cast<std::size_t>(std::clamp(x * 16, 0.0, 15.0)); }

  std::vector<double> counts_ = std::vector<double>(256);
  double total_ = 0, outside_ = 0;
};

// Independent numbers in [0, 1 − 2⁻²⁴], from a generator that is not the project's own.
class Uniform {
 public:
  explicit Uniform(std::uint64_t seed) : generator_(seed) {}

  float next() { return static_cast<float>(generator_() >> 40) * 0x1p-24f; }
  Vec2 next2() {
    const float x = next();
    const float y = next();
    return {x, y};
  }

 private:
  std::mt19937_64 generator_;
};

}  // namespace umbral::test
