// Moments and Student's t against published values and plain sums.
#include "core/statistics.h"

#include <cmath>
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

}  // namespace
}  // namespace umbral
