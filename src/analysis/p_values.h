// Many p-values at once.
#pragma once

#include <cstddef>
#include <vector>

namespace umbral {

// Which of them Holm's step-down procedure [Holm 1979] rejects, smallest first: the chance that any true hypothesis
// is among them is at most `alpha`, however they depend on each other.
std::vector<std::size_t> holm(const std::vector<double>& p, double alpha);

// The test of Kolmogorov and Smirnov that numbers are uniform in [0, 1], as p-values are where nothing differs and their
// errors are right.
struct UniformityTest {
  double statistic = 0;  // largest distance of the two distribution functions
  double p = 1;          // by the asymptotic distribution with the correction of [Stephens 1970]
};

// Of at least one number.
UniformityTest test_of_uniformity(std::vector<double> numbers);

// P(K > x) of Kolmogorov's distribution, the limit of √n times the statistic.
double kolmogorov_tail(double x);

}  // namespace umbral
