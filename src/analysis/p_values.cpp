// Holm's procedure, and Kolmogorov's distribution.
#include "analysis/p_values.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "core/math.h"

namespace umbral {

std::vector<std::size_t> holm(const std::vector<double>& p, double alpha) {
  std::vector<std::size_t> order(p.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return p[a] < p[b]; });
  std::size_t rejected = 0;
  while (rejected < order.size() &&
         p[order[rejected]] <= alpha / static_cast<double>(order.size() - rejected))
    ++rejected;
  order.resize(rejected);
  return order;
}

// P(K > x) = 2 Σ_{k≥1} (−1)^{k−1} exp(−2k²x²) or, quicker for small x,
//          = 1 − √(2π)/x Σ_{k≥1} exp(−(2k−1)²π²/8x²)
double kolmogorov_tail(double x) {
  if (x <= 0) return 1;
  double sum = 0;
  if (x < 1) {
    for (int k = 1; k <= 7; k += 2) sum += std::exp(-k * k * sqr(pi_d) / (8 * x * x));
    return 1 - std::sqrt(2 * pi_d) / x * sum;
  }
  for (int k = 1; k <= 5; ++k) sum += (k % 2 ? 2 : -2) * std::exp(-2 * k * k * x * x);
  return sum;
}

UniformityTest test_of_uniformity(std::vector<double> numbers) {
  std::sort(numbers.begin(), numbers.end());
  const auto n = static_cast<double>(numbers.size());
  UniformityTest test;
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    const auto below = static_cast<double>(i);
    test.statistic = std::max({test.statistic, numbers[i] - below / n, (below + 1) / n - numbers[i]});
  }
  test.p = kolmogorov_tail((std::sqrt(n) + 0.12 + 0.11 / std::sqrt(n)) * test.statistic);
  return test;
}

}  // namespace umbral
