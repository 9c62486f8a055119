// Running moments, their exact combination, and the tails of Student's t.
#pragma once

#include <cstdint>

namespace umbral {

// Count, mean and sum of squared deviations of numbers seen one by one [Welford 1962].
struct Moments {
  std::uint64_t n = 0;
  double mean = 0;
  double m2 = 0;  // Σ (x − mean)²

  void add(double x) {
    ++n;
    const double delta = x - mean;
    mean += delta / static_cast<double>(n);
    m2 += delta * (x - mean);
  }

  // Unbiased; 0 for fewer than two numbers.
  double variance() const { return n > 1 ? m2 / static_cast<double>(n - 1) : 0; }

  // Of the mean; infinite for fewer than two numbers, which tell nothing about it.
  double standard_error() const;
};

// The moments of both sets of numbers together [Chan et al. 1979].
Moments combined(const Moments& a, const Moments& b);

// The t such that Student's distribution with `dof` degrees of freedom holds `confidence` within ±t.
// confidence in (0, 1), dof > 0.
double student_quantile(double confidence, double dof);

// P(|T| ≥ |t|) under Student's distribution.
double student_two_sided_p(double t, double dof);

// P(F ≥ f) under Fisher's distribution of the ratio of two variances with so many degrees of freedom.
double fisher_upper_p(double f, double dof_above, double dof_below);

}  // namespace umbral
