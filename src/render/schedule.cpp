// Doubling passes and stop rules.
#include "render/schedule.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

namespace umbral {

std::uint64_t Schedule::next(double elapsed_seconds, double relative_error) {
  constexpr std::uint64_t longest_pass = 128;
  if (done_ >= rule_.samples) {
    reason_ = "samples";
    return 0;
  }
  if (done_ > 0 && rule_.relative_error > 0 && relative_error <= rule_.relative_error) {
    reason_ = fmt::format("target error {:.3g} %", 100 * rule_.relative_error);
    return 0;
  }
  std::uint64_t pass = std::min({std::max<std::uint64_t>(1, done_), longest_pass, rule_.samples - done_});
  if (done_ > 0 && std::isfinite(rule_.seconds)) {
    // The small excess keeps rounding from costing a sample.
    const auto done = static_cast<double>(done_);
    const double affordable = done * (rule_.seconds / elapsed_seconds) * (1 + 1e-12) - done;
    if (affordable < 1) {
      reason_ = fmt::format("time {:.3g} s", rule_.seconds);
      return 0;
    }
    pass = std::min(pass, static_cast<std::uint64_t>(affordable));
  }
  done_ += pass;
  return pass;
}

double Schedule::progress(double extra, double elapsed_seconds, double relative_error) const {
  const double samples = static_cast<double>(done_) + extra;
  double share = samples / static_cast<double>(rule_.samples);
  if (std::isfinite(rule_.seconds)) share = std::max(share, elapsed_seconds / rule_.seconds);
  if (rule_.relative_error > 0 && std::isfinite(relative_error) && relative_error > 0) {
    const double ratio = rule_.relative_error / relative_error;
    share = std::max(share, ratio * ratio);
  }
  return std::clamp(share, 0.0, 1.0);
}

}  // namespace umbral
