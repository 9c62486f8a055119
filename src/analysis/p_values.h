// Many p-values at once.
#pragma once

#include <cstddef>
#include <vector>

namespace umbral {

// Which of them Holm's step-down procedure [Holm 1979] rejects, smallest first: the chance that any true hypothesis
// is among them is at most `alpha`, however they depend on each other.
std::vector<std::size_t> holm(const std::vector<double>& p, double alpha);

}  // namespace umbral
