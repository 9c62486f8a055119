// Straight lines and interpolation on logarithms.
#include "analysis/convergence.h"

#include <algorithm>
#include "core/statistics.h"

namespace umbral {

LogEstimate ConvergencePoint::error() const {
  const Term terms[] = {{0.5, variance}};
  return combination(terms);
}

LogEstimate ConvergencePoint::efficiency() const {
  const Term terms[] = {{-1, variance}, {-1, seconds}};
  return combination(terms);
}

namespace {

double median_skewness(std::span<const ConvergencePoint> points) {
  std::vector<double> values;
  for (const ConvergencePoint& p : points) values.push_back(p.variance.skewness);
  std::nth_element(values.begin(), values.begin() + std::ssize(values) / 2, values.end());
  return values[values.size() / 2];
}

}  // namespace

// slope = Σ wᵢ yᵢ with wᵢ = (xᵢ − x̄)/Σ (xⱼ − x̄)². Straightness: the mean of the squared residuals over that of the
// points' variances is Fisher's F if these are alike, as they are for equally many replicates.
std::optional<PowerLaw> fitted_power_law(std::span<const ConvergencePoint> points) {
  const auto n = static_cast<double>(points.size());
  if (n < 3) return std::nullopt;
  double x_mean = 0, y_mean = 0, squares = 0;
  for (const ConvergencePoint& p : points) {
    x_mean += std::log(p.samples) / n;
    y_mean += p.variance.log / n;
  }
  for (const ConvergencePoint& p : points) squares += sqr(std::log(p.samples) - x_mean);
  std::vector<Term> terms, equal;
  for (const ConvergencePoint& p : points) {
    terms.push_back({(std::log(p.samples) - x_mean) / squares, p.variance});
    equal.push_back({1, p.variance});
  }
  const LogEstimate slope = combination(terms), total = combination(equal);
  double residuals = 0;
  for (const ConvergencePoint& p : points)
    residuals += sqr(p.variance.log - y_mean - slope.log * (std::log(p.samples) - x_mean));
  PowerLaw law{slope};
  law.slope.skewness = median_skewness(points);
  if (total.variance > 0)
    law.straightness_p =
        fisher_upper_p(residuals / (n - 2) / (total.variance / n), n - 2, total.degrees_of_freedom);
  return law;
}

LogEstimate slope_between(const ConvergencePoint& a, const ConvergencePoint& b) {
  const double step = std::log(b.samples / a.samples);
  const Term terms[] = {{1 / step, b.variance}, {-1 / step, a.variance}};
  return combination(terms);
}

namespace {

// With x the logarithm of the error and y what is interpolated, y = (1−w) y₀ + w y₁ at w = (x₀ − x)/(x₀ − x₁), and
// ∂y/∂x₀ = (1−w) (y₁−y₀)/(x₀−x₁), ∂y/∂x₁ = w (y₁−y₀)/(x₀−x₁).
LogEstimate interpolated(const LogEstimate& x0, const LogEstimate& x1, const LogEstimate& y0,
                         const LogEstimate& y1, double x) {
  const double step = x0.log - x1.log, w = (x0.log - x) / step, steepness = (y1.log - y0.log) / step;
  const Term terms[] = {{1 - w, y0}, {w, y1}, {(1 - w) * steepness, x0}, {w * steepness, x1}};
  LogEstimate result = combination(terms);
  result.log = (1 - w) * y0.log + w * y1.log;
  return result;
}

}  // namespace

std::optional<Effort> effort_to_reach(std::span<const ConvergencePoint> points, double error) {
  const double x = std::log(error);
  for (std::size_t i = 0; i + 1 < points.size(); ++i) {
    const ConvergencePoint &a = points[i], &b = points[i + 1];
    const LogEstimate before = a.error(), after = b.error();
    if (before.log < x || after.log > x || before.log == after.log) continue;
    const LogEstimate samples = interpolated(before, after, {std::log(a.samples)}, {std::log(b.samples)}, x);
    return Effort{samples, interpolated(before, after, a.seconds, b.seconds, x)};
  }
  return std::nullopt;
}

std::optional<Interval> common_errors(std::span<const ConvergencePoint> a,
                                      std::span<const ConvergencePoint> b) {
  if (a.empty() || b.empty()) return std::nullopt;
  const auto lowest = [](std::span<const ConvergencePoint> points) {
    double low = infinity;
    for (const ConvergencePoint& p : points) low = std::min(low, p.error().value());
    return low;
  };
  const Interval common{std::max(lowest(a), lowest(b)),
                        std::min(a.front().error().value(), b.front().error().value())};
  if (common.low > common.high) return std::nullopt;
  return common;
}

SpeedRatio speed_ratio(const LogEstimate& seconds_a, const LogEstimate& seconds_b, double confidence) {
  SpeedRatio result;
  result.ratio = ratio(seconds_a, seconds_b);
  result.interval = result.ratio.interval(confidence);
  if (result.ratio.skewed()) return result;
  if (result.interval.low > 1) result.faster = Faster::second;
  if (result.interval.high < 1) result.faster = Faster::first;
  return result;
}

}  // namespace umbral
