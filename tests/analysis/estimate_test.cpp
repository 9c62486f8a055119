// Means of replicates and their difference against values worked out by hand.
#include "analysis/estimate.h"

#include <vector>

#include <gtest/gtest.h>

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

TEST(Difference, KeepsTheErrorsOfBothSidesApart) {
  const Difference d =
      difference(mean_of(std::vector<double>{1, 2, 6}), mean_of(std::vector<double>{1, 2, 3, 10}));
  EXPECT_DOUBLE_EQ(d.value, 1);
  EXPECT_DOUBLE_EQ(d.error.variance_a, 7.0 / 3);
  EXPECT_DOUBLE_EQ(d.error.dof_a, 2);
  EXPECT_DOUBLE_EQ(d.error.variance_b, 50.0 / 12);
  EXPECT_DOUBLE_EQ(d.error.dof_b, 3);
}

}  // namespace
}  // namespace umbral
