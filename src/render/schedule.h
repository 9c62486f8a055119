// Schedule: how many samples the next pass takes, and when a render is done.
#pragma once

#include <cstdint>
#include <limits>
#include <string>

namespace umbral {

// When to stop: at whichever comes first. Counts are samples per pixel *and replicate*.
struct StopRule {
  std::uint64_t samples = std::numeric_limits<std::uint64_t>::max();
  double seconds = std::numeric_limits<double>::infinity();
  double relative_error = 0;  // RMS standard error over mean of the image; 0 asks for none
};

// Passes double what there is, so that replicates of a low-discrepancy set pass through powers of two, up to a
// bound that keeps sums in float exact enough; the last ones are cut to the samples and the time that are left.
class Schedule {
 public:
  explicit Schedule(const StopRule& rule) : rule_(rule) {}

  // Samples of the next pass; 0 once a rule says stop. `relative_error` is that of the film as it is.
  std::uint64_t next(double elapsed_seconds, double relative_error);

  std::uint64_t done() const { return done_; }
  // Which rule said stop, in words.
  const std::string& reason() const { return reason_; }

  // Share of the work that is done when `extra` samples beyond done() are: by the rule that will stop first.
  // `relative_error` falls like 1/√n at least.
  double progress(double extra, double elapsed_seconds, double relative_error) const;

 private:
  StopRule rule_;
  std::uint64_t done_ = 0;
  std::string reason_;
};

}  // namespace umbral
