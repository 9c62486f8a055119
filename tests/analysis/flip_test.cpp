// FLIP against the authors' program on one small image, and against what it must be by its definition.
#include "analysis/flip.h"

#include <gtest/gtest.h>

#include "support/random.h"

namespace umbral {
namespace {

struct Pair {
  Planes reference{48, 32}, test{48, 32};
};

// Ramps under a checkerboard; the other has a bent ramp, less contrast, a white pixel and a red corner.
Pair ramps() {
  Pair pair;
  for (int y = 0; y < 32; ++y)
    for (int x = 0; x < 48; ++x) {
      const std::size_t i = static_cast<std::size_t>(y) * 48 + x;
      const float u = (static_cast<float>(x) + 0.5f) / 48, v = (static_cast<float>(y) + 0.5f) / 32;
      const bool odd = (x / 6 + y / 6) % 2;
      const Vec3 r(u, v, odd ? 0.8f : 0.1f);
      Vec3 t(u * u, v, odd ? 0.7f : 0.15f);
      if (x == 20 && y == 11) t = Vec3(1);
      if (x == 0 && y == 31) t = Vec3(1, 0, 0);
      for (int c = 0; c < 3; ++c) {
        pair.reference.channels[c][i] = r[c];
        pair.test.channels[c][i] = t[c];
      }
    }
  return pair;
}

// The numbers are what the authors' C++ program, version 1.7, says of these images.
TEST(Flip, IsWhatTheAuthorsProgramSays) {
  const Pair pair = ramps();
  const Plane map = flip(pair.reference, pair.test);
  EXPECT_NEAR(mean(map), 0.326360, 1e-5);
  const struct {
    int x, y;
    float flip;
  } pixels[] = {{0, 0, 0.1322916f},   {20, 11, 0.4148976f}, {21, 12, 0.4082378f}, {24, 16, 0.4274115f},
                {47, 31, 0.0833282f}, {0, 31, 0.9713398f},  {3, 30, 0.3172521f},  {40, 5, 0.2416064f}};
  for (const auto& [x, y, expected] : pixels) EXPECT_NEAR(map.row(y)[x], expected, 2e-5) << x << ", " << y;
}

TEST(Flip, OfEqualImagesIsNothing) {
  const Pair pair = ramps();
  EXPECT_EQ(mean(flip(pair.reference, pair.reference)), 0);
}

// The largest distance of colours that there is: between pure green and blue.
TEST(Flip, OfGreenAndBlueIsOne) {
  Planes green(8, 8), blue(8, 8);
  std::fill(green.channels[1].begin(), green.channels[1].end(), 1.0f);
  std::fill(blue.channels[2].begin(), blue.channels[2].end(), 1.0f);
  EXPECT_NEAR(mean(flip(green, blue)), 1, 1e-5);
}

TEST(Flip, ImagesMayChangePlaces) {
  const Pair pair = ramps();
  const Plane there = flip(pair.reference, pair.test), back = flip(pair.test, pair.reference);
  for (std::size_t i = 0; i < there.values.size(); ++i) EXPECT_NEAR(there.values[i], back.values[i], 1e-6);
}

// Every pixel by its double sum, with borders that go on.
TEST(Convolution, IsTheDoubleSum) {
  test::Random random(1);
  Plane in(13, 9);
  for (float& value : in.values) value = random.number();
  const Kernel a{0.5f, -1, 2, 0.25f, 1}, b{1, 2, 3, -2, 0.5f}, c{0, 1, 0, 1, 0};
  const Plane out = filtered(in, {{a, b}, {c, a}});
  for (int y = 0; y < 9; ++y)
    for (int x = 0; x < 13; ++x) {
      double sum = 0;
      for (int j = -2; j <= 2; ++j)
        for (int i = -2; i <= 2; ++i) {
          const float value = in.row(std::clamp(y + j, 0, 8))[std::clamp(x + i, 0, 12)];
          sum += value * (a[i + 2] * b[j + 2] + c[i + 2] * a[j + 2]);
        }
      EXPECT_NEAR(out.row(y)[x], sum, 1e-5) << x << ", " << y;
    }
}

}  // namespace
}  // namespace umbral
