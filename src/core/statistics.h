// Running moments, their exact combination, the tails of Student's t, and limits of sums.
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

// Unbiased estimate of the variance of the sample variance of n ≥ 4 numbers whatever their distribution, from their
// sums of squared and of fourth powers of deviations from the mean, by k-statistics [Fisher 1930]:
//   (2n k2² + (n − 1) k4)/(n (n + 1))
// 2/(n + 1) of the squared sample variance where they are normal, all of it where one outlier makes them.
double variance_of_variance(double n, double squares, double fourth_powers);

// Upper confidence limit of the expectation of a sum of independent numbers ≥ 0, of which are known the sum, an
// estimate of its variance and the largest step it goes in, by the gamma distribution whose mean is sum + largest and
// whose variance is variance + largest² [Fay and Feuer 1997]: as if it were made of Poisson counts with weights, and
// one more of the largest weight had been missed. It needs no normal distribution and errs to the high side; what is
// too rare to have been seen at all it cannot know. 0 where the sum is. confidence in (0, 1), one-sided.
double upper_limit_of_sum(double sum, double variance, double largest, double confidence);

}  // namespace umbral
