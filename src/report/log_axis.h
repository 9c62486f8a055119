// LogAxis: places and labels along a logarithmic axis of a plot.
#pragma once

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "report/plot.h"

namespace umbral {

class LogAxis {
 public:
  /// From the smallest to the largest value, both > 0, to be drawn from `begin` to `end`; units of the picture.
  LogAxis(const PlotAxis& axis, double low, double high, double begin, double end)
      : axis_(axis), begin_(begin), end_(end) {
    const double margin = std::max(0.04 * std::log(high / low), 0.05);
    low_ = std::log(low) - margin;
    high_ = std::log(high) + margin;
  }

  double place(double value) const {
    return begin_ + (end_ - begin_) * (std::log(value) - low_) / (high_ - low_);
  }

  struct Tick {
    double value;
    std::string text;  // empty: a line alone
  };

  std::vector<Tick> ticks() const {
    return axis_.ticks == PlotAxis::Ticks::decades ? decades() : powers_of_two();
  }

 private:
  std::string text(double value) const {
    return axis_.percent ? fmt::format("{:g} %", 100 * value) : fmt::format("{:g}", value);
  }
  bool holds(double value) const { return std::log(value) >= low_ && std::log(value) <= high_; }

  // Lines at 1, 2, 5; between them too where there is room for it, and numbers for as many as fit.
  std::vector<Tick> decades() const {
    const double spanned = (high_ - low_) / std::log(10.0);
    std::vector<Tick> result;
    for (int e = static_cast<int>(std::floor(low_ / std::log(10.0))); e <= high_ / std::log(10.0); ++e)
      for (int digit = 1; digit < 10; ++digit) {
        const double value = digit * std::pow(10.0, e);
        const bool numbered = digit == 1 || (spanned < 3 && (digit == 2 || digit == 5)) || spanned < 0.7;
        if (holds(value) && (numbered || spanned < 3)) result.push_back({value, numbered ? text(value) : ""});
      }
    return result;
  }

  std::vector<Tick> powers_of_two() const {
    std::vector<Tick> result;
    const double spanned = (high_ - low_) / std::log(2.0);
    const int step = std::max(1, static_cast<int>(std::ceil(spanned / 10)));
    for (int e = static_cast<int>(std::floor(low_ / std::log(2.0))); e <= high_ / std::log(2.0); ++e)
      if (holds(std::exp2(e))) result.push_back({std::exp2(e), e % step == 0 ? text(std::exp2(e)) : ""});
    return result;
  }

  const PlotAxis& axis_;
  double low_, high_;  // logarithms
  double begin_, end_;
};

}  // namespace umbral
