// Holm's procedure by hand, Kolmogorov's distribution by its tables.
#include "analysis/p_values.h"

#include <algorithm>

#include <gtest/gtest.h>

namespace umbral {
namespace {

TEST(Holm, StepsDown) {
  EXPECT_EQ(holm({0.04, 0.012, 0.3, 0.001}, 0.05), (std::vector<std::size_t>{3, 1}));
  EXPECT_EQ(holm({0.02, 0.02}, 0.05), (std::vector<std::size_t>{0, 1}));
  EXPECT_TRUE(holm({0.03, 0.03}, 0.05).empty());
}

// The five-, one- and ten-per-cent points of the limit distribution, as in any table.
TEST(Uniformity, LimitIsKolmogorovs) {
  EXPECT_NEAR(kolmogorov_tail(1.22385), 0.10, 1e-5);
  EXPECT_NEAR(kolmogorov_tail(1.35810), 0.05, 1e-5);
  EXPECT_NEAR(kolmogorov_tail(1.62762), 0.01, 1e-5);
  EXPECT_NEAR(kolmogorov_tail(0.82757), 0.50, 1e-5);  // the median
  EXPECT_NEAR(kolmogorov_tail(0.999999), kolmogorov_tail(1.000001), 1e-5);
}

// Critical values at 5 % for small n: 0.409 for 10, 0.294 for 20 [Massey 1951].
TEST(Uniformity, SmallSamplesHaveThePublishedCriticalValues) {
  for (const auto& [n, critical] : {std::pair{10, 0.409}, {20, 0.294}}) {
    // All of n numbers moved up so that the largest distance is the critical one.
    std::vector<double> numbers;
    for (int i = 0; i < n; ++i) numbers.push_back(std::min(1.0, static_cast<double>(i) / n + critical));
    const UniformityTest test = test_of_uniformity(numbers);
    EXPECT_NEAR(test.statistic, critical, 1e-12);
    EXPECT_NEAR(test.p, 0.05, 0.002) << n;
  }
}

}  // namespace
}  // namespace umbral
