// Moments, and distributions by Boost.Math.
#include "core/statistics.h"

#include <cmath>
#include <limits>

#include <boost/math/distributions/fisher_f.hpp>
#include <boost/math/distributions/normal.hpp>
#include <boost/math/distributions/students_t.hpp>
#include <boost/math/special_functions/gamma.hpp>

namespace umbral {

double Moments::standard_error() const {
  if (n < 2) return std::numeric_limits<double>::infinity();
  return std::sqrt(variance() / static_cast<double>(n));
}

Moments combined(const Moments& a, const Moments& b) {
  if (a.n == 0) return b;
  if (b.n == 0) return a;
  const auto na = static_cast<double>(a.n), nb = static_cast<double>(b.n);
  const double delta = b.mean - a.mean;
  return {a.n + b.n, a.mean + delta * (nb / (na + nb)), a.m2 + b.m2 + delta * delta * (na * nb / (na + nb))};
}

double student_quantile(double confidence, double dof) {
  return boost::math::quantile(boost::math::students_t(dof), 0.5 + 0.5 * confidence);
}

double student_two_sided_p(double t, double dof) {
  return 2 * boost::math::cdf(boost::math::complement(boost::math::students_t(dof), std::abs(t)));
}

double fisher_upper_p(double f, double dof_above, double dof_below) {
  return boost::math::cdf(boost::math::complement(boost::math::fisher_f(dof_above, dof_below), f));
}

double variance_of_variance(double n, double squares, double fourth_powers) {
  const double k2 = squares / (n - 1);
  const double k4 =
      (n * (n + 1) * fourth_powers - 3 * (n - 1) * squares * squares) / ((n - 1) * (n - 2) * (n - 3));
  return (2 * n * k2 * k2 + (n - 1) * k4) / (n * (n + 1));
}

double upper_limit_of_sum(double sum, double variance, double largest, double confidence) {
  if (!(sum > 0)) return 0;
  const double mean = sum + largest, scale = (variance + largest * largest) / mean, shape = mean / scale;
  if (shape > 1e6)  // normal to within 1/shape
    return mean * (1 + boost::math::quantile(boost::math::normal(), confidence) / std::sqrt(shape));
  return scale * boost::math::gamma_p_inv(shape, confidence);
}

}  // namespace umbral
