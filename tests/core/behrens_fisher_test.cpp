// Behrens and Fisher's distribution: where it is known otherwise, and that tests by it keep their level.
#include "core/behrens_fisher.h"

#include <random>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "core/statistics.h"

namespace umbral {
namespace {

TEST(BehrensFisher, IsStudentsWhereOneSideIsKnown) {
  const BehrensFisher error{0, infinity, 4, 3};
  EXPECT_NEAR(error.two_sided_p(5), student_two_sided_p(2.5, 3), 1e-12);
  EXPECT_NEAR(error.half_width(0.99), 2 * student_quantile(0.99, 3), 1e-9);
  EXPECT_EQ(BehrensFisher{}.two_sided_p(0), 1);
  EXPECT_EQ(BehrensFisher{}.two_sided_p(1), 0);
}

// Student's with one degree of freedom is Cauchy's, of which the sum is one again, as wide as both together.
TEST(BehrensFisher, OfOneDegreeOfFreedomIsASumOfCauchys) {
  for (const double sigma : {1e-6, 1e-3, 0.1, 1.0, 30.0}) {
    const BehrensFisher error{sqr(sigma), 1, 1, 1};
    for (const double distance : {0.1, 1.0, 10.0, 1e4})
      EXPECT_NEAR(error.two_sided_p(distance) / student_two_sided_p(distance / (1 + sigma), 1), 1, 1e-4)
          << sigma << ' ' << distance;
    EXPECT_NEAR(error.half_width(0.999) / ((1 + sigma) * student_quantile(0.999, 1)), 1, 1e-3) << sigma;
  }
}

// Two means that agree but for their last digit, as those of a sum in another order do.
TEST(BehrensFisher, IsSureOfNothingAtTheLeastDistance) {
  const BehrensFisher error{1, 7, 2, 15};
  for (const double distance : {1e-6, 1e-16, 1e-30, 1e-308}) {
    EXPECT_NEAR(error.two_sided_p(distance), 1, 1e-5) << distance;
    EXPECT_LE(error.two_sided_p(distance), 1 + 1e-9) << distance;
  }
}

// 5 % points of [Sukhatme 1938] for equal degrees of freedom and tan² θ = variance_a/variance_b.
TEST(BehrensFisher, HasThePointsOfItsTable) {
  const struct {
    double dof, degrees, point;
  } rows[] = {{6, 0, 2.447},  {6, 45, 2.435},  {8, 15, 2.300},
              {8, 45, 2.292}, {12, 30, 2.169}, {12, 45, 2.167}};
  for (const auto& row : rows) {
    const double theta = row.degrees * pi_d / 180;
    const BehrensFisher error{sqr(std::sin(theta)), row.dof, sqr(std::cos(theta)), row.dof};
    EXPECT_NEAR(error.half_width(0.95), row.point, 1e-3) << row.dof << ' ' << row.degrees;
  }
}

// Normal data, equal means: how often is p below 1 %? 1000 runs a row, so ± 0.32 %; 2.4 % is over four standard errors off. Welch's
// t has up to 9 %.
TEST(BehrensFisher, KeepsItsLevelWithFewReplicatesWhateverTheirSpreads) {
  const double dofs[][2] = {{1, 1}, {1000, 1}, {1000, 3}, {7, 1}, {7, 7}, {15, 15}};
  std::mt19937_64 random(7);
  for (const auto& [dof_a, dof_b] : dofs)
    for (const double share_a : {0.9, 0.5, 0.1, 0.01}) {
      std::gamma_distribution<double> spread_a(dof_a / 2, 2 / dof_a * share_a);
      std::gamma_distribution<double> spread_b(dof_b / 2, 2 / dof_b * (1 - share_a));
      std::normal_distribution<double> difference;
      int alarms = 0;
      for (int run = 0; run < 1000; ++run) {
        const BehrensFisher error{spread_a(random), dof_a, spread_b(random), dof_b};
        alarms += error.two_sided_p(std::abs(difference(random))) < 0.01;
      }
      EXPECT_LT(alarms, 24) << dof_a << ' ' << dof_b << ' ' << share_a;
    }
}

// How often Welch's t of that level rejects equal means, as a multiple of the level: the mean, over the estimated variances, of
// what the normal distribution leaves beyond its critical value. 10 000 draws; good to a tenth.
double size_of_welch(double dof_a, double dof_b, double share_a, double level) {
  std::mt19937_64 random(3);
  std::gamma_distribution<double> spread_a(dof_a / 2, 2 / dof_a * share_a);
  std::gamma_distribution<double> spread_b(dof_b / 2, 2 / dof_b * (1 - share_a));
  constexpr int draws = 10'000;
  double sum = 0;
  for (int i = 0; i < draws; ++i) {
    const double a = spread_a(random), b = spread_b(random);
    const double dof = sqr(a + b) / (sqr(a) / dof_a + sqr(b) / dof_b);
    sum += std::erfc(student_quantile(1 - level, dof) * std::sqrt((a + b) / 2));
  }
  return sum / draws / level;
}

// Why there is this distribution: at the level of one tile among two hundred, beside a side that is well known.
TEST(BehrensFisher, IsNeededFarOutInTheTails) {
  constexpr double level = 5e-6;
  double few = 0;
  for (const double dof : {1.0, 3.0, 7.0, 15.0}) {
    double worst = 0;
    for (const double share : {0.5, 0.3, 0.1, 0.03, 0.01})
      worst = std::max(worst, size_of_welch(1000, dof, share, level));
    if (dof == 1) few = worst;
    fmt::print("  {} replicates: Welch's t rejects {:.3g} times as often as it should\n", dof + 1, worst);
  }
  EXPECT_GT(few, 1000);
  const BehrensFisher even{1, 15, 1, 15};
  const double wider = even.half_width(1 - level) / (std::sqrt(2.0) * student_quantile(1 - level, 30));
  fmt::print("  16 and 16 replicates, equal spreads: {:.3g} times as wide as Welch's\n", wider);
  EXPECT_NEAR(wider, 1.09, 0.02);
}

// And with many it does not give away what Welch's t can see.
TEST(BehrensFisher, IsWelchsWithManyReplicates) {
  const BehrensFisher few{1, 150, 2, 180}, many{1, 250, 2, 280};
  for (const double confidence : {0.8, 0.999, 1 - 5e-6}) {
    EXPECT_NEAR(few.half_width(confidence) / (std::sqrt(3.0) * student_quantile(confidence, 330)), 1, 0.01);
    EXPECT_NEAR(many.half_width(confidence) / (std::sqrt(3.0) * student_quantile(confidence, 500)), 1, 0.01);
  }
}

}  // namespace
}  // namespace umbral
