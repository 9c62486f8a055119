// Moments and Student's t, the latter by Boost.Math.
#include "core/statistics.h"

#include <cmath>
#include <limits>

#include <boost/math/distributions/fisher_f.hpp>
#include <boost/math/distributions/students_t.hpp>

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

}  // namespace umbral
