// How often Student's t with its own σ errs on skewed samples: why whole images, and not samples, are its data.
#include <gtest/gtest.h>

#include <fmt/format.h>

#include "analysis/distributions.h"
#include "core/statistics.h"

namespace umbral::test {
namespace {

struct Row {
  Draw draw;
  int n, runs;
  double at_1, at_001;  // false alarms at nominal 1 % and 0.01 %, per cent, of a computation of their own
};

class StudentCalibration : public testing::TestWithParam<Row> {};

// Of one-sample tests against the true mean. A rate may be off by four standard errors of its runs and by how far the
// expectation is rounded.
TEST_P(StudentCalibration, FalseAlarmsAreKnown) {
  const auto& [draw, n, runs, at_1, at_001] = GetParam();
  Random random(static_cast<std::uint64_t>(1 + static_cast<int>(draw)) * 1000 +
                static_cast<std::uint64_t>(n));
  int alarms_1 = 0, alarms_001 = 0;
  for (int run = 0; run < runs; ++run) {
    Moments moments;
    for (int i = 0; i < n; ++i) moments.add(drawn(draw, random));
    const double error = moments.standard_error();
    const double p = error > 0 ? student_two_sided_p((moments.mean - mean_of(draw)) / error, n - 1) : 0;
    alarms_1 += p <= 0.01;
    alarms_001 += p <= 0.0001;
  }
  const auto expect_rate = [runs = runs](int alarms, double percent) {
    const double p = percent / 100, rounding = 0.06 * p + 0.0003;
    EXPECT_NEAR(static_cast<double>(alarms) / runs, p, 4 * std::sqrt(p * (1 - p) / runs) + rounding);
  };
  expect_rate(alarms_1, at_1);
  expect_rate(alarms_001, at_001);
  fmt::print("  | {} | {} | {:.2f} % | {:.2f} % |\n", draw_names[static_cast<int>(draw)], n,
             100.0 * alarms_1 / runs, 100.0 * alarms_001 / runs);
}

INSTANTIATE_TEST_SUITE_P(
    Table, StudentCalibration,
    testing::Values(Row{Draw::uniform, 32, 20'000, 1.0, 0.01}, Row{Draw::lognormal_1, 32, 20'000, 6.0, 1.3},
                    Row{Draw::lognormal_1_5, 4096, 3000, 2.0, 0.14}, Row{Draw::firefly, 256, 8000, 77, 73},
                    Row{Draw::firefly, 65'536, 400, 1.7, 0.10}, Row{Draw::bernoulli, 256, 8000, 7.6, 7.6}));

}  // namespace
}  // namespace umbral::test
