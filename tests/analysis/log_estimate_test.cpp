// Arithmetic of logarithms with error bars, and intervals that hold the truth as often as they say.
#include "analysis/log_estimate.h"

#include <gtest/gtest.h>

#include "analysis/synthetic_replicates.h"
#include "core/statistics.h"

namespace umbral::test {
namespace {

TEST(LogEstimate, CombinesAsProductsOfPowers) {
  const LogEstimate a{std::log(8.0), 0.01, 10}, b{std::log(2.0), 0.04, 20};
  const Term terms[] = {{2, a}, {-1, b}};
  const LogEstimate c = combination(terms);
  EXPECT_NEAR(c.value(), 32, 1e-12);
  EXPECT_NEAR(c.variance, 4 * 0.01 + 0.04, 1e-15);
  EXPECT_NEAR(c.degrees_of_freedom, 0.08 * 0.08 / (0.04 * 0.04 / 10 + 0.04 * 0.04 / 20), 1e-9);
  EXPECT_NEAR(ratio(a, b).value(), 4, 1e-12);
}

TEST(LogEstimate, WhatIsExactStaysSo) {
  const LogEstimate a{std::log(3.0)};
  const LogEstimate c = ratio(a, a);
  EXPECT_EQ(c.variance, 0);
  EXPECT_EQ(c.interval(0.95).low, 1);
  EXPECT_EQ(c.interval(0.95).high, 1);
}

TEST(LogEstimate, IntervalsAreStudents) {
  const LogEstimate a{0, 0.01, 15};
  EXPECT_NEAR(a.interval(0.95).high, std::exp(0.1 * student_quantile(0.95, 15)), 1e-12);
  EXPECT_NEAR(a.interval(0.95).low * a.interval(0.95).high, 1, 1e-12);
}

// The jackknife of a mean is its variance exactly; of its logarithm to first order.
TEST(LogEstimate, TheJackknifeOfAMeanIsItsStandardError) {
  const std::vector<double> values = {10.1, 9.7, 10.4, 9.9, 10.2, 9.8};
  Moments moments;
  double sum = 0;
  for (const double v : values) moments.add(v), sum += v;
  const auto log = jackknifed(values.size(), [&](std::size_t i) {
    return i < values.size() ? (sum - values[i]) / (static_cast<double>(values.size()) - 1)
                             : sum / static_cast<double>(values.size());
  });
  ASSERT_TRUE(log);
  EXPECT_NEAR(log->value(), 10.0166667, 1e-6);
  EXPECT_NEAR(log->standard_error(), moments.standard_error() / moments.mean, 1e-5);
  EXPECT_EQ(log->degrees_of_freedom, 5);
  EXPECT_FALSE(jackknifed(3, [](std::size_t i) { return i == 1 ? 0.0 : 1.0; }));
}

TEST(LogEstimate, AMeanOfTimesIsGeometric) {
  const std::vector<double> times = {1, 2, 4};
  EXPECT_NEAR(geometric_mean(times).value(), 2, 1e-12);
  EXPECT_NEAR(geometric_mean(times).variance, sqr(std::log(2.0)) / 3, 1e-12);
  EXPECT_EQ(geometric_mean(times).degrees_of_freedom, 2);
}

}  // namespace
}  // namespace umbral::test
