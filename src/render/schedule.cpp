// Doubling passes and stop rules.
#include "render/schedule.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

namespace umbral {
namespace {

// After so many samples a replicate without any light, one who waits for a relative error waits in vain.
constexpr std::uint64_t patience = 128;

}  // namespace

std::string target_text(double relative_error, const TargetError& target) {
  const std::string limit = std::isfinite(target.limit)
                                ? fmt::format("at most {:.3g} % with {:g} % confidence", 100 * target.limit,
                                              100 * (1 - target_alpha))
                                : "the error is unknown";
  return fmt::format("target error {:.3g} % {}: {}", 100 * relative_error,
                     target.reached ? "reached" : "not reached", limit);
}

std::string Schedule::reason() const {
  if (rule_.relative_error == 0 || reason_.empty()) return reason_;
  const std::string target = target_text(rule_.relative_error, target_);
  return target_.reached ? target : reason_ + "; " + target;
}

// A look.
bool Schedule::reached(const ImageError& error) {
  const double looks = ++target_.looks;
  target_.limit = error.relative_limit(1 - target_alpha / (looks * (looks + 1)));
  target_.reached = target_.limit <= rule_.relative_error;
  const auto done = static_cast<double>(done_);
  const double needed =
      done * sqr(target_.limit / rule_.relative_error);  // the error falls like 1/√n at least
  next_look_ = static_cast<std::uint64_t>(std::ceil(glm::clamp(needed, 1.125 * done, 2 * done)));
  return target_.reached;
}

std::uint64_t Schedule::stop(const std::string& reason, const ImageError& error) {
  reason_ = reason;
  if (rule_.relative_error > 0) reached(error);
  return 0;
}

std::uint64_t Schedule::next(double elapsed_seconds, const ImageError& error) {
  constexpr std::uint64_t longest_pass = 128;
  const bool has_target = rule_.relative_error > 0;
  if (done_ >= rule_.samples) return stop("samples", error);
  if (has_target && done_ >= next_look_ && reached(error)) {
    reason_ = "target error";
    return 0;
  }
  if (has_target && done_ >= patience && error.mean == 0) return stop("no light in any sample", error);

  std::uint64_t pass = std::min({std::max<std::uint64_t>(1, done_), longest_pass, rule_.samples - done_});
  if (has_target && next_look_ > done_) pass = std::min(pass, next_look_ - done_);
  if (done_ > 0 && std::isfinite(rule_.seconds)) {
    // The small excess keeps rounding from costing a sample.
    const auto done = static_cast<double>(done_);
    const double affordable = done * (rule_.seconds / elapsed_seconds) * (1 + 1e-12) - done;
    if (affordable < 1) return stop(fmt::format("time {:.3g} s", rule_.seconds), error);
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
