// Sums of logarithms and of their variances.
#include "analysis/log_estimate.h"

#include <algorithm>
#include <vector>

#include "core/statistics.h"

namespace umbral {
namespace {

double cube(double x) { return x * x * x; }

}  // namespace

double LogEstimate::value() const { return std::exp(log); }

double LogEstimate::standard_error() const { return std::sqrt(variance); }

Interval LogEstimate::log_interval(double confidence) const {
  const double half_width = student_quantile(confidence, degrees_of_freedom) * standard_error();
  return {log - half_width, log + half_width};
}

Interval LogEstimate::interval(double confidence) const {
  const Interval logs = log_interval(confidence);
  return {std::exp(logs.low), std::exp(logs.high)};
}

LogEstimate combination(std::span<const Term> terms) {
  LogEstimate sum;
  double spread = 0;  // Σ variance²/ν
  for (const auto& [factor, estimate] : terms) {
    const double variance = factor * factor * estimate.variance;
    sum.log += factor * estimate.log;
    if (factor != 0) sum.skewness = std::max(sum.skewness, estimate.skewness);
    sum.variance += variance;
    spread += variance * variance / estimate.degrees_of_freedom;
  }
  if (spread > 0) sum.degrees_of_freedom = sum.variance * sum.variance / spread;
  return sum;
}

LogEstimate ratio(const LogEstimate& a, const LogEstimate& b) {
  const Term terms[] = {{1, a}, {-1, b}};
  return combination(terms);
}

std::optional<LogEstimate> jackknifed(std::size_t count, const std::function<double(std::size_t)>& without) {
  const double all = without(count);
  if (!(all > 0)) return std::nullopt;
  std::vector<double> logs;
  Moments moments;
  for (std::size_t i = 0; i < count; ++i) {
    const double value = without(i);
    if (!(value > 0)) return std::nullopt;
    logs.push_back(-std::log(value));
    moments.add(logs.back());
  }
  const auto n = static_cast<double>(count);
  double cubes = 0;
  for (const double log : logs) cubes += cube(log - moments.mean) / n;
  const double deviation = std::sqrt(moments.m2 / n);
  return LogEstimate{std::log(all), (n - 1) / n * moments.m2, n - 1,
                     deviation > 0 ? cubes / cube(deviation) : 0};
}

LogEstimate geometric_mean(std::span<const double> values) {
  Moments logs;
  for (const double value : values) logs.add(std::log(value));
  const auto n = static_cast<double>(values.size());
  return {logs.mean, logs.variance() / n, n - 1};
}

}  // namespace umbral
