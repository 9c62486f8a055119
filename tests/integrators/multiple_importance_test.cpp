// Weights of multiple importance sampling against long double, for densities of any size.
#include "integrators/multiple_importance.h"

#include <gtest/gtest.h>

#include "support/random.h"
#include "support/stability.h"

namespace umbral {
namespace {

using namespace test;

double reference(float p, float q) {
  const long double p2 = static_cast<long double>(p) * p, q2 = static_cast<long double>(q) * q;
  return static_cast<double>(p2 / (p2 + q2));
}

// Squares of densities pass the largest float at 1.8e19: a mirror of alpha 0.001 reaches 1e5, a light of 1e-12 sr 1e12.
TEST(PowerHeuristic, KeepsItsDigitsForDensitiesOfAnySize) {
  Random random(1);
  double worst = 0, worst_sum = 0;
  for (int i = 0; i < 100'000; ++i) {
    const auto p = static_cast<float>(random.log_between(1e-37, 3e38));
    const auto q =
        static_cast<float>(i % 2 == 0 ? random.log_between(1e-37, 3e38) : p * random.between(0.1, 0.9));
    const float w = power_heuristic(p, q);
    ASSERT_TRUE(w >= 0 && w <= 1) << p << " " << q;
    // Weights that are as small as this are next to another of 1.
    worst = std::max(worst, std::abs(w - reference(p, q)) / std::max(reference(p, q), 1e-30));
    worst_sum = std::max(worst_sum, std::abs(static_cast<double>(w) + power_heuristic(q, p) - 1));
  }
  EXPECT_LE(worst, 1e-6);
  EXPECT_LE(worst_sum, 2.5e-7);
  record({"Lobes", "MIS weights overflow or lose digits, densities from 1e-37 to 3e38",
          "≤ 1e-6 relative, sum 1 ± 2.5e-7", fmt::format("{:.1e}, sum 1 ± {:.1e}", worst, worst_sum),
          "p²/(p² + q²): NaN from 1.8e19 on"});
}

TEST(PowerHeuristic, IsCertainWhereOneStrategyAloneCouldHaveDrawn) {
  for (const float p : {1e-45f, 1e-20f, 1.0f, 1e20f, 3.4e38f}) {
    EXPECT_EQ(power_heuristic(p, 0), 1);
    EXPECT_EQ(power_heuristic(0, p), 0);
    EXPECT_EQ(power_heuristic(p, p), 0.5f);
  }
  EXPECT_EQ(power_heuristic(0, 0), 0);
  EXPECT_EQ(power_heuristic(1e-45f, 3.4e38f), 0);
  EXPECT_EQ(power_heuristic(3.4e38f, 1e-45f), 1);
}

}  // namespace
}  // namespace umbral
