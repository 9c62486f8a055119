// The noises: their range, smoothness, spread, and the nearest points by brute force.
#include "core/noise.h"

#include <gtest/gtest.h>

#include "core/hash.h"
#include "support/random.h"

namespace umbral {
namespace {

using test::Random;

TEST(GradientNoise, IsZeroAtWholeNumbersAndKeepsItsRange) {
  Random random(1);
  float lowest = 0, highest = 0;
  double squares = 0;
  constexpr int n = 200'000;
  for (int i = 0; i < n; ++i) {
    const Vec3 p(random.in_cube(1000));
    EXPECT_EQ(gradient_noise(glm::floor(p)), 0);
    const float value = gradient_noise(p);
    lowest = std::min(lowest, value);
    highest = std::max(highest, value);
    squares += static_cast<double>(value) * static_cast<double>(value) / n;
  }
  EXPECT_GE(lowest, -1);
  EXPECT_LE(highest, 1);
  EXPECT_LT(lowest, -0.7f);
  EXPECT_GT(highest, 0.7f);
  EXPECT_NEAR(std::sqrt(squares), 0.27, 0.03);
}

// No step at the sides of cubes, in value or slope.
TEST(GradientNoise, IsSmoothAcrossCubes) {
  Random random(2);
  for (int i = 0; i < 20'000; ++i) {
    const Vec3 p = glm::round(Vec3(random.in_cube(50)) * Vec3(1, 1, 0)) + Vec3(0, random.square());
    const Vec3 step(1e-3f, 0, 0);
    const float before = gradient_noise(p) - gradient_noise(p - step),
                after = gradient_noise(p + step) - gradient_noise(p);
    EXPECT_NEAR(before, after, 1e-4f);
    EXPECT_LT(std::abs(after), 5e-3f);
  }
}

TEST(GradientNoise, OfNumbersBeyondTheLatticeIsZero) {
  for (const float x : {2e9f, -1e30f, infinity, -infinity, std::nanf("")}) {
    EXPECT_EQ(gradient_noise({x, 0.5f, 0.5f}), 0);
    EXPECT_EQ(nearest_points({0.5f, x, 0.5f}).first, 0);
  }
}

TEST(FractalNoise, KeepsItsRangeAndAddsDetail) {
  Random random(3);
  for (int i = 0; i < 20'000; ++i) {
    const Vec3 p(random.in_cube(20));
    EXPECT_LE(std::abs(fractal_noise(p, 8, 0.7f)), 1);
    EXPECT_EQ(fractal_noise(p, 1, 0.5f), gradient_noise(p));
    EXPECT_FLOAT_EQ(fractal_noise(p, 2, 0.5f), (gradient_noise(p) + 0.5f * gradient_noise(2.0f * p)) / 1.5f);
  }
}

// Found by looking at few cubes, as by looking at all: F1 and F2 are continuous everywhere, and F1 ≤ F2.
TEST(NearestPoints, MissNoPoint) {
  Random random(4);
  for (int i = 0; i < 2000; ++i) {
    const Vec3 from(random.in_cube(30));
    const Vec3 way(random.direction());
    NearestPoints last = nearest_points(from);
    for (int k = 1; k <= 50; ++k) {
      const NearestPoints now = nearest_points(from + way * (0.02f * static_cast<float>(k)));
      EXPECT_LE(now.first, now.second);
      // A distance to a point changes by no more than the way.
      EXPECT_LE(std::abs(now.first - last.first), 0.0201f);
      EXPECT_LE(std::abs(now.second - last.second), 0.0201f);
      EXPECT_TRUE(now.number >= 0 && now.number < 1);
      last = now;
    }
  }
}

}  // namespace
}  // namespace umbral
