// Convergence: how error falls with samples and with time, and which of two ways is faster.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "analysis/log_estimate.h"

namespace umbral {

/// What the replicates of one number of samples tell. Points are independent of each other.
struct ConvergencePoint {
  double samples = 0;    // a pixel, in each replicate
  LogEstimate variance;  // of a pixel, mean over pixels and channels, in units of the image's mean squared
  LogEstimate seconds;   // of one replicate

  LogEstimate error() const;       // √variance: RMS relative error
  LogEstimate efficiency() const;  // 1/(variance · seconds), 1/s
};

/// variance ∝ samples^slope, fitted to logarithms. −1 is Monte Carlo, −1.5 scrambled nets on integrands with edges, −3
/// on smooth ones [Owen 1997].
struct PowerLaw {
  LogEstimate slope;          // its `log` is the slope, its skewness the median of the points'
  double straightness_p = 1;  // the chance of points as far from a straight line if they lay on one

  // Whether the points are shown not to lie on a line; with skewed noise nothing is shown.
  bool bent() const { return straightness_p < 0.01 && !slope.skewed(); }
};

/// Ordinary least squares, whose weights do not depend on the noise, with the error that the points' own error bars
/// imply: right for the mean slope over the range even if the points do not lie on a line. Nothing for fewer than 3
/// points. `points` by ascending samples, in equal ratios.
std::optional<PowerLaw> fitted_power_law(std::span<const ConvergencePoint> points);

/// The slope between two points, as `log`.
LogEstimate slope_between(const ConvergencePoint& a, const ConvergencePoint& b);

/// What it takes to reach an RMS relative error, interpolated on logarithms between the two neighbours where the curve
/// first passes it; nothing if it never does: nothing is extrapolated.
struct Effort {
  LogEstimate samples, seconds;
};
std::optional<Effort> effort_to_reach(std::span<const ConvergencePoint> points, double error);

/// The errors that both curves pass through; nothing if there are none.
std::optional<Interval> common_errors(std::span<const ConvergencePoint> a,
                                      std::span<const ConvergencePoint> b);

enum class Faster { first, second, neither };  // neither: not shown

/// How many times as fast as `a` is `b`: seconds of a over seconds of b.
struct SpeedRatio {
  LogEstimate ratio;
  Interval interval;
  Faster faster = Faster::neither;  // as shown: neither where the interval holds 1 or either side is skewed
};
SpeedRatio speed_ratio(const LogEstimate& seconds_a, const LogEstimate& seconds_b, double confidence);

}  // namespace umbral
