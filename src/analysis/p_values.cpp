// Holm's procedure.
#include "analysis/p_values.h"

#include <algorithm>
#include <numeric>

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

}  // namespace umbral
