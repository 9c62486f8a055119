// Schedule: how many samples the next pass takes, and when a render is done.
#pragma once

#include <cstdint>
#include <limits>
#include <string>

#include "image/film.h"

namespace umbral {

// When to stop: at whichever comes first. Counts are samples per pixel *and replicate*.
struct StopRule {
  std::uint64_t samples = std::numeric_limits<std::uint64_t>::max();
  double seconds = std::numeric_limits<double>::infinity();
  double relative_error = 0;  // RMS standard error over mean of the image; 0 asks for none
};

// The chance that a render stops by the target error although the expected error is above it, over all looks.
inline constexpr double target_alpha = 0.05;

// What the target error came to. A look is a comparison of the error with the target.
struct TargetError {
  int looks = 0;
  double limit =
      std::numeric_limits<double>::infinity();  // upper confidence limit of the error at the last look
  bool reached = false;
};

// Passes double what there is, so that replicates of a low-discrepancy set pass through powers of two, up to a
// bound that keeps sums in float exact enough; the last ones are cut to the samples and the time that are left.
//
// The target error counts as reached when its upper confidence limit is below it [the estimate itself is too low half
// of the time, and the lowest of many looks more often]. Each look may err: the k-th is given target_alpha/(k (k + 1))
// of the chance to, and these add up to target_alpha however many there are. Looks are where the samples have doubled
// or where the target is expected, so they are few; the first waits for four samples, which tell a little of the tails.
class Schedule {
 public:
  explicit Schedule(const StopRule& rule) : rule_(rule) {}

  // Samples of the next pass; 0 once a rule says stop. `error` is that of the film as it is.
  std::uint64_t next(double elapsed_seconds, const ImageError& error);

  std::uint64_t done() const { return done_; }
  // Which rule said stop and, where a target error was asked for, what was reached; in words.
  std::string reason() const;
  const TargetError& target() const { return target_; }

  // Share of the work that is done when `extra` samples beyond done() are: by the rule that will stop first.
  // `relative_error` falls like 1/√n at least.
  double progress(double extra, double elapsed_seconds, double relative_error) const;

 private:
  bool reached(const ImageError& error);
  std::uint64_t stop(const std::string& reason, const ImageError& error);

  StopRule rule_;
  std::uint64_t done_ = 0;
  std::uint64_t next_look_ = 4;
  TargetError target_;
  std::string reason_;
};

// "target error 1 % reached: at most 0.982 % with 95 % confidence", or that it was not.
std::string target_text(double relative_error, const TargetError& target);

}  // namespace umbral
