// Pearson's χ² of counted draws against the numbers expected of them.
#pragma once

#include <algorithm>
#include <cmath>
#include <numeric>
#include <span>
#include <vector>

#include <boost/math/distributions/chi_squared.hpp>

namespace umbral::test {

struct ChiSquare {
  double statistic = 0;
  int degrees = 0;  // of freedom
  double p = 1;     // to find a statistic as large by chance
};

/// Cells of which fewer than 5 draws are expected are pooled, smallest first. The expected numbers must sum to the
/// number of draws, so a cell for rejected draws belongs among them. p = 0 where the impossible was drawn.
inline ChiSquare chi_square(std::span<const double> observed, std::span<const double> expected) {
  std::vector<std::size_t> order(expected.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::sort(order.begin(), order.end(),
            [&](std::size_t a, std::size_t b) { return expected[a] < expected[b]; });
  ChiSquare result;
  int cells = 0;
  double pooled_observed = 0, pooled_expected = 0;
  for (std::size_t i = 0; i < order.size(); ++i) {
    pooled_observed += observed[order[i]];
    pooled_expected += expected[order[i]];
    if (pooled_expected < 5 && i + 1 < order.size()) continue;
    if (pooled_expected <= 0) {
      if (pooled_observed > 0) return {HUGE_VAL, cells, 0};
      continue;
    }
    const double difference = pooled_observed - pooled_expected;
    result.statistic += difference * difference / pooled_expected;
    ++cells;
    pooled_observed = pooled_expected = 0;
  }
  result.degrees = cells - 1;
  if (result.degrees < 1) return result;
  result.p =
      boost::math::cdf(boost::math::complement(boost::math::chi_squared(result.degrees), result.statistic));
  return result;
}

}  // namespace umbral::test
