// The filters: what sample() draws follows cdf() exactly.
#include "image/filter.h"

#include <cmath>
#include <cstdint>

#include <gtest/gtest.h>

namespace umbral {
namespace {

constexpr Filter filters[] = {{FilterKind::box},           {FilterKind::tent},
                              {FilterKind::gaussian},      {FilterKind::box, 2.25f},
                              {FilterKind::tent, 0.75f},   {FilterKind::gaussian, 3},
                              {FilterKind::gaussian, 0.5f}};

// cdf(sample(u)) = u: the inverse is exact up to the rounding of a float.
TEST(Filter, SampleInvertsTheCumulativeDistribution) {
  for (const Filter& filter : filters)
    for (std::uint32_t i = 0; i < (1u << 24); i += 1 + (i >> 14)) {
      const float u = static_cast<float>(i) * 0x1p-24f;
      const Vec2 p = filter.sample({u, 0.5f});
      ASSERT_NEAR(filter.cdf(p.x), u, 2e-7)
          << EnumNames<FilterKind>::names[static_cast<int>(filter.kind)] << u;
      ASSERT_EQ(p.x, filter.sample({0.25f, u}).y);
    }
}

TEST(Filter, StaysWithinItsRadius) {
  for (const Filter& filter : filters) {
    EXPECT_EQ(filter.sample({0.5f, 0.5f}), Vec2(0));
    for (const float u : {0.0f, 0x1p-24f, 0.25f, 0.5f, 0.75f, one_minus_epsilon}) {
      const Vec2 p = filter.sample({u, u});
      EXPECT_LE(std::abs(p.x), filter.effective_radius());
      EXPECT_TRUE(is_finite(p));
    }
  }
}

TEST(Filter, IsSymmetricAndMonotonic) {
  for (const Filter& filter : filters) {
    float last = filter.sample({0, 0}).x;
    for (int i = 1; i < 4096; ++i) {
      const float u = static_cast<float>(i) / 4096;
      const float x = filter.sample({u, 0}).x;
      EXPECT_GE(x, last);
      EXPECT_NEAR(filter.sample({1 - u, 0}).x, -x, 1e-6f * filter.effective_radius());
      last = x;
    }
  }
}

// The density is the derivative of the distribution and integrates to 1.
TEST(Filter, DensityBelongsToTheDistribution) {
  for (const Filter& filter : filters) {
    const double r = filter.effective_radius();
    EXPECT_EQ(filter.cdf(-r), 0);
    EXPECT_EQ(filter.cdf(r), 1);
    EXPECT_EQ(filter.density(1.001 * r), 0);
    for (int i = -9; i <= 9; ++i) {
      const double x = 0.1 * i * r + 0.01 * r, h = 1e-5 * r;
      EXPECT_NEAR(filter.density(x), (filter.cdf(x + h) - filter.cdf(x - h)) / (2 * h), 1e-8 / r);
    }
  }
}

TEST(Filter, GaussianHasTheStatedWidth) {
  const Filter filter{FilterKind::gaussian};
  EXPECT_EQ(filter.effective_radius(), 1.5f);
  EXPECT_NEAR(filter.density(0.5) / filter.density(0), std::exp(-0.5), 1e-12);
  // The variance of a normal deviate cut off at 3σ is (1 − 6φ(3)/(2Φ(3) − 1)) σ².
  double variance = 0;
  constexpr int n = 100'000;
  for (int i = 0; i < n; ++i)
    variance += sqr(double{filter.sample({(static_cast<float>(i) + 0.5f) / n, 0}).x}) / n;
  EXPECT_NEAR(variance, 0.25 * (1 - 6 * 0.004431848411938008 / 0.9973002039367398), 1e-5);
}

TEST(Filter, DefaultRadii) {
  EXPECT_EQ(Filter{FilterKind::box}.effective_radius(), 0.5f);
  EXPECT_EQ(Filter{FilterKind::tent}.effective_radius(), 1.0f);
  EXPECT_EQ(Filter{}.kind, FilterKind::gaussian);
}

}  // namespace
}  // namespace umbral
