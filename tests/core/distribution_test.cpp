// Distributions: every one of the 2²⁴ numbers that a sampler can draw goes where the stored table says.
#include "core/distribution.h"

#include <numeric>
#include <stdexcept>
#include <vector>

#include <gtest/gtest.h>

#include "chi_square.h"

namespace umbral {
namespace {

constexpr double all_numbers = 1 << 24;

// How often each index is drawn when u runs over all floats k·2⁻²⁴.
std::vector<double> all_draws(const Distribution1D& distribution) {
  std::vector<double> counts(distribution.size());
  for (std::uint32_t k = 0; k < (1u << 24); ++k)
    ++counts[distribution.sample(static_cast<float>(k) * 0x1p-24f).index];
  return counts;
}

TEST(Distribution1D, EveryNumberGoesWhereTheTableSays) {
  const std::vector<double> weights{0, 3, 0, 1, 1e-3, 0, 7.25, 1e-5, 0.1, 0, 0};
  const Distribution1D distribution(weights);
  const std::vector<double> counts = all_draws(distribution);
  const double sum = std::accumulate(weights.begin(), weights.end(), 0.0);
  for (std::size_t i = 0; i < weights.size(); ++i) {
    const double probability = distribution.probability(i);
    EXPECT_EQ(counts[i], probability * all_numbers) << i;
    EXPECT_NEAR(probability, weights[i] / sum, 1e-7) << i;
    if (weights[i] == 0) {
      EXPECT_EQ(counts[i], 0) << i;
      EXPECT_EQ(probability, 0) << i;
    }
  }
  EXPECT_NEAR(distribution.sum(), sum, 1e-12);
}

// Shares far below a step of the sampler's numbers, beside one that takes nearly all, at every place of the list.
TEST(Distribution1D, EveryPositiveWeightIsDrawn) {
  const std::vector<double> first{1, 1e-12, 0, 1e-300, 1e-9, 1e-12},
      middle{1e-12, 1e-12, 0, 1, 1e-9, 0, 1e-20}, last{0, 1e-12, 1e-9, 1e-12, 1},
      halves{1e-12, 1, 1e-12, 1, 1e-12, 0};
  for (const std::vector<double>& weights : {first, middle, last, halves}) {
    const Distribution1D distribution(weights);
    const std::vector<double> counts = all_draws(distribution);
    for (std::size_t i = 0; i < weights.size(); ++i) {
      EXPECT_EQ(counts[i], distribution.probability(i) * all_numbers) << i;
      EXPECT_EQ(counts[i] > 0, weights[i] > 0) << i;
    }
  }
}

TEST(Distribution1D, MoreWeightsThanNumbersAreRefused) {
  const std::vector<double> too_many((1 << 24) + 1, 1.0);
  EXPECT_THROW(Distribution1D{too_many}, std::length_error);
}

TEST(Distribution1D, ZeroWeightsAreNeverDrawnAtTheEnds) {
  const std::vector<double> first{0, 0, 1, 2}, last{1, 2, 0, 0}, middle{0, 5, 0};
  for (const float u : {0.0f, 0x1p-24f, one_minus_epsilon}) {
    EXPECT_GE(Distribution1D(first).sample(u).index, 2u) << u;
    EXPECT_LE(Distribution1D(last).sample(u).index, 1u) << u;
    const Distribution1D::Draw draw = Distribution1D(middle).sample(u);
    EXPECT_EQ(draw.index, 1u) << u;
    EXPECT_EQ(draw.probability, 1) << u;
    EXPECT_LT(draw.remainder, 1) << u;
  }
}

TEST(Distribution1D, DrawsTellTheirProbabilityAndAUniformRemainder) {
  const std::vector<double> weights{1, 0, 10, 0.01, 5};
  const Distribution1D distribution(weights);
  test::UniformSquareTest uniform;
  test::Uniform random(3);
  for (int i = 0; i < 400'000; ++i) {
    const Distribution1D::Draw draw = distribution.sample(random.next());
    EXPECT_EQ(draw.probability, distribution.probability(draw.index));
    EXPECT_GE(draw.remainder, 0);
    EXPECT_LE(draw.remainder, one_minus_epsilon);
    if (draw.index == 2) uniform.add(draw.remainder, random.next());
  }
  EXPECT_GT(uniform.p(), 1e-4);
}

TEST(Distribution1D, AllZeroIsUniformAndOneIsCertain) {
  const std::vector<double> none(5), single{0.25};
  const Distribution1D uniform(none);
  for (std::size_t i = 0; i < 5; ++i) EXPECT_NEAR(uniform.probability(i), 0.2, 1e-7);
  EXPECT_EQ(uniform.sum(), 0);
  EXPECT_EQ(Distribution1D(single).sample(0.7f).index, 0u);
  EXPECT_EQ(Distribution1D(single).probability(0), 1);
  EXPECT_FLOAT_EQ(Distribution1D(single).sample(0.7f).remainder, 0.7f);
  EXPECT_EQ(Distribution1D().size(), 0u);
}

TEST(Distribution1D, ManyWeightsSumToOneExactly) {
  std::vector<double> weights(100'003);
  test::Uniform random(4);
  for (double& weight : weights) weight = random.next();
  const Distribution1D distribution(weights);
  double sum = 0;
  for (std::size_t i = 0; i < weights.size(); ++i) sum += distribution.probability(i);
  EXPECT_EQ(sum, 1);
}

// Weights that do not fit into a float, large and small.
TEST(Distribution1D, OnlyRatiosMatter) {
  const std::vector<double> large{1e300, 3e300}, small{1e-300, 3e-300};
  EXPECT_EQ(Distribution1D(large).probability(0), 0.25f);
  EXPECT_EQ(Distribution1D(small).probability(0), 0.25f);
}

class Distribution2DTest : public testing::Test {
 protected:
  static constexpr std::size_t width = 16, height = 16;
  std::vector<double> weights() const {
    std::vector<double> w(width * height);
    for (std::size_t y = 0; y < height; ++y)
      for (std::size_t x = 0; x < width; ++x)
        w[y * width + x] = y == 5 || (x + y) % 7 == 0 ? 0 : 0.1 + static_cast<double>(x * y % 11);
    return w;
  }
};

TEST_F(Distribution2DTest, DrawsFollowTheWeights) {
  const std::vector<double> w = weights();
  const Distribution2D distribution(w, width, height);
  const double sum = std::accumulate(w.begin(), w.end(), 0.0);
  EXPECT_NEAR(distribution.sum(), sum, 1e-10);
  std::vector<double> counts(w.size()), expected(w.size());
  constexpr double n = 1e6;
  glm::dvec2 remainders(0);
  test::Uniform random(5);
  for (int i = 0; i < n; ++i) {
    const Distribution2D::Draw draw = distribution.sample(random.next2());
    ++counts[draw.y * width + draw.x];
    ASSERT_EQ(draw.probability, distribution.probability(draw.x, draw.y));
    for (const float r : {draw.remainder.x, draw.remainder.y}) ASSERT_TRUE(r >= 0 && r < 1);
    remainders += glm::dvec2(draw.remainder) / n;
  }
  EXPECT_NEAR(remainders.x, 0.5, 2e-3);
  EXPECT_NEAR(remainders.y, 0.5, 2e-3);
  for (std::size_t i = 0; i < w.size(); ++i) expected[i] = n * w[i] / sum;
  EXPECT_GT(test::chi_square_p(counts, expected), 1e-4);
}

TEST_F(Distribution2DTest, ProbabilitiesAreTheSharesOfTheWeights) {
  const std::vector<double> w = weights();
  const Distribution2D distribution(w, width, height);
  double sum = 0;
  for (std::size_t y = 0; y < height; ++y)
    for (std::size_t x = 0; x < width; ++x) {
      const double probability = distribution.probability(x, y);
      EXPECT_NEAR(probability, w[y * width + x] / distribution.sum(), 1e-4 * probability);
      sum += probability;
    }
  EXPECT_NEAR(sum, 1, 1e-6);
}

TEST_F(Distribution2DTest, EdgesAreSafe) {
  const Distribution2D distribution(weights(), width, height);
  for (const float a : {0.0f, 0x1p-24f, 0.5f, one_minus_epsilon})
    for (const float b : {0.0f, 0x1p-24f, 0.5f, one_minus_epsilon})
      EXPECT_GT(distribution.sample({a, b}).probability, 0);
}

}  // namespace
}  // namespace umbral
