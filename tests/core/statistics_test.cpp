// Moments and Student's t against published values and plain sums.
#include "core/statistics.h"

#include <array>
#include <cmath>
#include <functional>
#include <random>
#include <vector>

#include <gtest/gtest.h>

namespace umbral {
namespace {

Moments moments_of(const std::vector<double>& numbers, std::size_t begin, std::size_t end) {
  Moments moments;
  for (std::size_t i = begin; i < end; ++i) moments.add(numbers[i]);
  return moments;
}

// Mean 1e6 with deviation 1: the sum of squares minus the square of the sum would lose all digits in float
// and half of them in double.
std::vector<double> awkward_numbers() {
  std::mt19937_64 random(1);
  std::normal_distribution<double> normal(1e6, 1);
  std::vector<double> numbers(10'000);
  for (double& x : numbers) x = normal(random);
  return numbers;
}

TEST(Moments, EqualTwoPasses) {
  const std::vector<double> numbers = awkward_numbers();
  long double sum = 0, squares = 0;
  for (const double x : numbers) sum += x;
  const long double mean = sum / numbers.size();
  for (const double x : numbers) squares += (x - mean) * (x - mean);
  const Moments moments = moments_of(numbers, 0, numbers.size());
  EXPECT_EQ(moments.n, numbers.size());
  EXPECT_NEAR(moments.mean, static_cast<double>(mean), 1e-8);
  EXPECT_NEAR(moments.m2 / static_cast<double>(squares), 1, 1e-10);
  EXPECT_DOUBLE_EQ(moments.variance(), moments.m2 / 9999);
  EXPECT_DOUBLE_EQ(moments.standard_error(), std::sqrt(moments.variance() / 10'000));
}

TEST(Moments, CombineAsIfSeenTogether) {
  const std::vector<double> numbers = awkward_numbers();
  const Moments all = moments_of(numbers, 0, numbers.size());
  for (const std::size_t split : {0, 1, 17, 5000, 9999, 10'000}) {
    const Moments both = combined(moments_of(numbers, 0, split), moments_of(numbers, split, numbers.size()));
    EXPECT_EQ(both.n, all.n);
    EXPECT_NEAR(both.mean, all.mean, 1e-8);
    EXPECT_NEAR(both.m2 / all.m2, 1, 1e-10) << split;
  }
}

TEST(Moments, FewNumbersTellNothingOfTheirError) {
  Moments moments;
  EXPECT_TRUE(std::isinf(moments.standard_error()));
  EXPECT_EQ(moments.variance(), 0);
  moments.add(3);
  EXPECT_EQ(moments.mean, 3);
  EXPECT_TRUE(std::isinf(moments.standard_error()));
  moments.add(5);
  EXPECT_DOUBLE_EQ(moments.standard_error(), 1);
}

// The tables of any book; 1, 3, 7 and 15 degrees of freedom are 2, 4, 8 and 16 replicates.
TEST(Student, QuantilesAreThePublishedOnes) {
  EXPECT_NEAR(student_quantile(0.95, 1), 12.706, 5e-4);
  EXPECT_NEAR(student_quantile(0.95, 3), 3.182, 5e-4);
  EXPECT_NEAR(student_quantile(0.95, 7), 2.365, 5e-4);
  EXPECT_NEAR(student_quantile(0.95, 15), 2.131, 5e-4);
  EXPECT_NEAR(student_quantile(0.99, 7), 3.499, 5e-4);
  EXPECT_NEAR(student_quantile(0.95, 1e9), 1.960, 5e-4);
}

TEST(Student, PIsTheInverseOfTheQuantile) {
  for (const double dof : {1.0, 2.5, 7.0, 15.0, 300.0})
    for (const double confidence : {0.5, 0.95, 0.999})
      for (const double sign : {-1.0, 1.0})
        EXPECT_NEAR(student_two_sided_p(sign * student_quantile(confidence, dof), dof), 1 - confidence,
                    1e-12);
  EXPECT_DOUBLE_EQ(student_two_sided_p(0, 5), 1);
  EXPECT_NEAR(student_two_sided_p(1, 1), 0.5, 1e-12);  // Cauchy
}

// The tables of any book, and the square of Student's t.
TEST(Fisher, TailsAreThePublishedOnes) {
  EXPECT_NEAR(fisher_upper_p(4.965, 1, 10), 0.05, 5e-5);
  EXPECT_NEAR(fisher_upper_p(3.326, 5, 10), 0.05, 5e-5);
  EXPECT_NEAR(fisher_upper_p(5.636, 5, 10), 0.01, 5e-5);
  for (const double t : {0.5, 1.0, 3.0})
    EXPECT_NEAR(fisher_upper_p(t * t, 1, 7), student_two_sided_p(t, 7), 1e-12);
  EXPECT_DOUBLE_EQ(fisher_upper_p(0, 3, 3), 1);
}

// Of samples of eight numbers, normal and very much not so: the estimate is right on average.
TEST(VarianceOfVariance, IsUnbiasedWhateverTheDistribution) {
  std::mt19937_64 random(8);
  std::normal_distribution<double> normal;
  std::exponential_distribution<double> exponential;
  const std::function<double()> draws[] = {[&] { return normal(random); },
                                           [&] { return exponential(random); },
                                           [&] { return random() % 20 == 0 ? 1.0 : 0.0; }};
  for (const auto& draw : draws) {
    Moments estimates, variances;
    for (int run = 0; run < 40'000; ++run) {
      std::array<double, 8> numbers;
      Moments moments;
      for (double& x : numbers) moments.add(x = draw());
      double fourth_powers = 0;
      for (const double x : numbers) fourth_powers += std::pow(x - moments.mean, 4);
      variances.add(moments.variance());
      estimates.add(variance_of_variance(8, moments.m2, fourth_powers));
    }
    EXPECT_NEAR(estimates.mean / variances.variance(), 1, 0.1);
  }
  // One outlier of 8: mean 1/8, squares 7/8, fourth powers 7 (1/8)⁴ + (7/8)⁴.
  EXPECT_NEAR(variance_of_variance(8, 7.0 / 8, (7 + 2401) / 4096.0), 1.0 / 64, 1e-15);
}

// With weights of 1 it is the exact upper limit of a Poisson count, as in any book's tables.
TEST(UpperLimit, OfCountsIsThePublishedOne) {
  EXPECT_NEAR(upper_limit_of_sum(1, 1, 1, 0.975), 5.572, 5e-4);
  EXPECT_NEAR(upper_limit_of_sum(3, 3, 1, 0.975), 8.767, 5e-4);
  EXPECT_NEAR(upper_limit_of_sum(10, 10, 1, 0.95), 16.962, 5e-4);
  EXPECT_NEAR(upper_limit_of_sum(20, 40, 2, 0.95), 2 * 16.962, 1e-3);
  EXPECT_EQ(upper_limit_of_sum(0, 0, 0, 0.95), 0);
}

// Sums of 200 exponential numbers with unequal means: the limit is above the truth in 95 % of cases or somewhat more.
TEST(UpperLimit, OfSumsOfUnequalNumbersHolds) {
  std::mt19937_64 random(3);
  std::exponential_distribution<double> exponential;
  int held = 0;
  constexpr int runs = 4000;
  for (int run = 0; run < runs; ++run) {
    double sum = 0, squares = 0, largest = 0, truth = 0;
    for (int i = 1; i <= 200; ++i) {
      const double mean = 1.0 / i, x = mean * exponential(random);
      truth += mean;
      sum += x;
      squares += x * x;
      largest = std::max(largest, x);
    }
    held += upper_limit_of_sum(sum, squares, largest, 0.95) >= truth;
  }
  EXPECT_GE(held, 0.94 * runs);
  EXPECT_LE(held, 0.995 * runs);
}

}  // namespace
}  // namespace umbral
