// Means of replicates and Welch's difference against values worked out elsewhere.
#include "analysis/estimate.h"

#include <vector>

#include <gtest/gtest.h>

#include "core/statistics.h"

namespace umbral {
namespace {

TEST(MeanEstimate, OfReplicates) {
  const std::vector<double> values{1, 2, 3, 10};
  const MeanEstimate mean = mean_of(values);
  EXPECT_DOUBLE_EQ(mean.value, 4);
  EXPECT_DOUBLE_EQ(mean.variance, 50.0 / 3 / 4);
  EXPECT_DOUBLE_EQ(mean.degrees_of_freedom, 3);
  EXPECT_NEAR(mean.skewness, (-27 - 8 - 1 + 216) / 4.0 / std::pow(12.5, 1.5), 1e-12);
}

TEST(MeanEstimate, OfOneValueIsExact) {
  const MeanEstimate mean = mean_of(std::vector<double>{7});
  EXPECT_EQ(mean.value, 7);
  EXPECT_EQ(mean.variance, 0);
  EXPECT_TRUE(std::isinf(mean.degrees_of_freedom));
}

// Student's sleep data [1908], by Welch: t = −1.8608, df = 17.776, p = 0.07939, as in the manual of R's t.test().
TEST(Difference, IsWelchs) {
  const std::vector<double> first{0.7, -1.6, -0.2, -1.2, -0.1, 3.4, 3.7, 0.8, 0.0, 2.0};
  const std::vector<double> second{1.9, 0.8, 1.1, 0.1, -0.1, 4.4, 5.5, 1.6, 4.6, 3.4};
  const MeanEstimate d = difference(mean_of(second), mean_of(first));
  const double t = d.value / std::sqrt(d.variance);
  EXPECT_NEAR(t, -1.8608, 5e-5);
  EXPECT_NEAR(d.degrees_of_freedom, 17.776, 5e-4);
  EXPECT_NEAR(student_two_sided_p(t, d.degrees_of_freedom), 0.07939, 5e-6);
}

// Against a truth what is left is the one-sample test.
TEST(Difference, ToATruthHasTheDegreesOfFreedomOfTheOther) {
  const MeanEstimate d = difference(MeanEstimate{2}, mean_of(std::vector<double>{1, 2, 3, 10}));
  EXPECT_DOUBLE_EQ(d.value, 2);
  EXPECT_DOUBLE_EQ(d.degrees_of_freedom, 3);
  EXPECT_DOUBLE_EQ(d.variance, 50.0 / 12);
}

}  // namespace
}  // namespace umbral
