// Passes and stop rules without a render.
#include "render/schedule.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace umbral::test {
namespace {

constexpr double endless = std::numeric_limits<double>::infinity();

// Of an image of so many pixels that its upper limit is the error itself.
ImageError error_of(double relative) {
  ImageError error;
  error.mean = 1;
  error.rms_standard_error = relative;
  return error;
}

std::vector<std::uint64_t> passes(const StopRule& rule, double seconds_a_sample, double error_of_one_sample) {
  Schedule schedule(rule);
  std::vector<std::uint64_t> result;
  while (true) {
    const auto done = static_cast<double>(schedule.done());
    const double error = done > 0 ? error_of_one_sample / std::sqrt(done) : endless;
    const std::uint64_t pass = schedule.next(seconds_a_sample * done, error_of(error));
    if (pass == 0 || result.size() > 10000) return result;
    result.push_back(pass);
  }
}

std::uint64_t sum(const std::vector<std::uint64_t>& passes) {
  std::uint64_t total = 0;
  for (const std::uint64_t pass : passes) total += pass;
  return total;
}

TEST(Schedule, PassesDoubleUpToABoundAndEndAtTheSamplesAsked) {
  EXPECT_EQ(passes({100}, 0.001, 1), (std::vector<std::uint64_t>{1, 1, 2, 4, 8, 16, 32, 36}));
  EXPECT_EQ(passes({1}, 0.001, 1), (std::vector<std::uint64_t>{1}));
  const std::vector<std::uint64_t> long_run = passes({1000}, 0.001, 1);
  EXPECT_EQ(sum(long_run), 1000u);
  for (const std::uint64_t pass : long_run) EXPECT_LE(pass, 128u);
}

TEST(Schedule, TimeIsKept) {
  StopRule rule;
  rule.seconds = 10;
  for (const double seconds_a_sample : {0.001, 0.03, 0.7, 4.0}) {
    const auto n = static_cast<double>(sum(passes(rule, seconds_a_sample, 1)));
    EXPECT_LE(n * seconds_a_sample, 10 * (1 + 1e-9));
    EXPECT_GT((n + 1) * seconds_a_sample, 10 * (1 - 1e-9));
  }
  EXPECT_EQ(sum(passes(rule, 25, 1)), 1u);  // never without a sample
}

// Not by doubling on: what is missing is known from the error so far.
TEST(Schedule, ErrorIsReachedAndNotMuchMore) {
  StopRule rule;
  rule.relative_error = 0.05;  // at 400 samples
  const std::uint64_t n = sum(passes(rule, 0.001, 1));
  EXPECT_GE(n, 400u);
  EXPECT_LE(n, 404u);
}

// The chances to err of all looks, however many, add up to what is promised.
TEST(Schedule, TheLimitWidensWithEachLookAndSoAllTogetherKeepTheirPromise) {
  ImageError error = error_of(0.1);
  error.relative_variance = 0.01;
  error.largest_step = 0.02;
  Schedule schedule({.relative_error = 1e-6});
  double sum = 0, limit = 0;
  for (int look = 1; look < 40; ++look) {
    while (schedule.target().looks < look) schedule.next(1, error);
    EXPECT_GT(schedule.target().limit, limit);
    limit = schedule.target().limit;
    const double alpha = target_alpha / (look * (look + 1.0));
    EXPECT_DOUBLE_EQ(limit, error.relative_limit(1 - alpha));
    sum += alpha;
  }
  EXPECT_LT(sum, target_alpha);
  EXPECT_GT(limit, 0.12);
  EXPECT_LT(limit, 0.15);
}

// Between looks no chance to err is spent, so looks must be few: about as many as doublings.
TEST(Schedule, LooksAreFew) {
  Schedule schedule({.relative_error = 0.001});  // at 10⁶ samples
  while (schedule.next(1, error_of(1 / std::sqrt(static_cast<double>(schedule.done()))))) {
  }
  EXPECT_GE(schedule.done(), 1000000u);
  EXPECT_LE(schedule.done(), 1010000u);
  EXPECT_LE(schedule.target().looks, 23);
}

TEST(Schedule, TheLastLookIsWhereAnotherRuleStops) {
  Schedule missed({.samples = 100, .relative_error = 0.01}), reached({.samples = 100, .relative_error = 0.1});
  for (Schedule* schedule : {&missed, &reached})
    while (schedule->next(1, error_of(0.99 / std::sqrt(static_cast<double>(schedule->done()))))) {
    }
  EXPECT_EQ(missed.done(), 100u);
  EXPECT_FALSE(missed.target().reached);
  EXPECT_EQ(missed.reason(), "samples; target error 1 % not reached: at most 9.9 % with 95 % confidence");
  EXPECT_TRUE(reached.target().reached);
  EXPECT_EQ(reached.reason(), "target error 10 % reached: at most 9.95 % with 95 % confidence");
}

TEST(Schedule, DarknessIsNotWaitedForForEver) {
  Schedule schedule({.relative_error = 0.01});
  ImageError dark;
  dark.rms_standard_error = 0;
  while (schedule.next(1, dark)) ASSERT_LT(schedule.done(), 10000u);
  EXPECT_EQ(schedule.reason(), "no light in any sample; target error 1 % not reached: the error is unknown");
}

TEST(Schedule, TheFirstRuleWins) {
  StopRule rule{50, 1e9, 1e-9};
  EXPECT_EQ(sum(passes(rule, 0.001, 1)), 50u);
  rule = {1000000, 0.5, 1e-9};
  EXPECT_EQ(sum(passes(rule, 0.001, 1)), 500u);
  rule = {1000000, 1e9, 0.25};
  EXPECT_EQ(sum(passes(rule, 0.001, 1)), 16u);
}

TEST(Schedule, TellsWhichRuleItWas) {
  const auto reason = [](const StopRule& rule) {
    Schedule schedule(rule);
    while (schedule.next(static_cast<double>(schedule.done()),
                         error_of(schedule.done() > 0 ? 0.02 : endless)) > 0) {
    }
    return schedule.reason();
  };
  EXPECT_EQ(reason({64}), "samples");
  EXPECT_EQ(reason({1000, 4}), "time 4 s");
  EXPECT_EQ(reason({1000, 4, 0.03}), "target error 3 % reached: at most 2 % with 95 % confidence");
}

TEST(Schedule, ProgressGrowsToTheEndOfTheRuleThatStops) {
  Schedule schedule({64, 100, 0.1});
  double before = 0;
  while (const std::uint64_t pass = schedule.next(0.001 * static_cast<double>(schedule.done()),
                                                  error_of(schedule.done() > 0 ? 5 : endless))) {
    const double begin = schedule.progress(-static_cast<double>(pass), 0.001, 5);
    const double end = schedule.progress(0, 0.001, 5);
    EXPECT_GE(begin, before - 1e-12);
    EXPECT_GT(end, begin);
    before = end;
  }
  EXPECT_EQ(before, 1);
  EXPECT_NEAR(Schedule({1000, 10, 0}).progress(0, 5, 1), 0.5, 1e-12);
  EXPECT_NEAR(Schedule({1000, 1e9, 0.1}).progress(0, 5, 0.2), 0.25, 1e-12);
}

}  // namespace
}  // namespace umbral::test
