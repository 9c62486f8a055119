// Images over all directions: the mappings, their stretch, how their edges join, and densities that are their look-up's.
#include "scene/lights/sphere_mapping.h"

#include <gtest/gtest.h>

#include "scene/lights/sphere_distribution.h"
#include "support/chi_square.h"
#include "support/quadrature.h"
#include "support/random.h"

namespace umbral {
namespace {

using namespace test;

class EveryMapping : public testing::TestWithParam<SphereMapping> {};

TextureImage image_of(int width, int height, const auto& value) {
  TexelGrid<Float4> grid(width, height);
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) grid.set(x, y, Spectrum(static_cast<float>(value(x, y))));
  return TextureImage(TextureImage::Texels(std::move(grid)));
}

int width_of(SphereMapping mapping, int height) {
  return mapping == SphereMapping::equirectangular ? 2 * height : height;
}

TEST_P(EveryMapping, IsInvertible) {
  Random random(1);
  for (int i = 0; i < 20'000; ++i) {
    const Vec3d d = random.direction();
    const Vec2 square = square_of(GetParam(), Vec3(d));
    EXPECT_TRUE(square.x >= 0 && square.x <= 1 && square.y >= 0 && square.y <= 1);
    EXPECT_LT(glm::length(Vec3d(direction_of(GetParam(), square)) - d), 2e-6);
    const Vec2 u = random.square(), back = square_of(GetParam(), direction_of(GetParam(), u));
    EXPECT_LT(glm::length(back - u) * stretch_at(GetParam(), direction_of(GetParam(), u)), 3e-5f);
  }
}

// |∂ω/∂x × ∂ω/∂y| by differences, away from the folds.
TEST_P(EveryMapping, StretchesAsItSays) {
  Random random(2);
  int tried = 0;
  for (int i = 0; i < 3000; ++i) {
    const Vec2 u = random.square() * 0.98f + 0.01f;
    const auto near = [](float x) { return std::abs(x) < 0.01f; };
    const Vec2 p = glm::abs(2.0f * u - 1.0f);
    if (near(p.x) || near(p.y) || near(p.x + p.y - 1)) continue;
    constexpr float h = 0x1p-10f;
    const auto at = [&](float x, float y) { return Vec3d(direction_of(GetParam(), u + Vec2(x, y))); };
    const Vec3d by_x = (at(h, 0) - at(-h, 0)) / (2.0 * h), by_y = (at(0, h) - at(0, -h)) / (2.0 * h);
    EXPECT_NEAR(glm::length(cross(by_x, by_y)) / stretch_at(GetParam(), direction_of(GetParam(), u)), 1,
                2e-3);
    ++tried;
  }
  EXPECT_GT(tried, 2000);
}

TEST_P(EveryMapping, GoesOnBeyondItsEdges) {
  Random random(3);
  for (int i = 0; i < 1000; ++i) {
    const float along = static_cast<float>(random.between(0.01, 0.99)), step = 1e-4f;
    for (const auto& [inside, outside] : {std::pair{Vec2(step, along), Vec2(-step, along)},
                                          {Vec2(1 - step, along), Vec2(1 + step, along)},
                                          {Vec2(along, step), Vec2(along, -step)},
                                          {Vec2(along, 1 - step), Vec2(along, 1 + step)}}) {
      const Vec2 back = folded(GetParam(), outside);
      ASSERT_TRUE(back.x >= 0 && back.x <= 1 && back.y >= 0 && back.y <= 1);
      EXPECT_LT(glm::length(direction_of(GetParam(), inside) - direction_of(GetParam(), back)), 3e-3f);
    }
  }
}

// What a look-up sees must not jump anywhere.
TEST_P(EveryMapping, IsSeenWithoutSeams) {
  Random random(4);
  const int height = 8, width = width_of(GetParam(), height);
  const TextureImage image = image_of(width, height, [&](int, int) { return random.between(0, 1); });
  for (int i = 0; i < 100'000; ++i) {
    const Vec3d d = random.direction(), e = glm::normalize(d + 1e-4 * random.direction());
    if (GetParam() == SphereMapping::equirectangular && std::abs(d.y) > 0.98)
      continue;  // many columns meet there
    EXPECT_NEAR(seen_along(image, GetParam(), Vec3(d)).r, seen_along(image, GetParam(), Vec3(e)).r, 5e-3);
  }
}

// ∫ pdf dω over half texels, in which it is smooth, against where samples fall; a texel 10⁶ times as bright as others.
TEST_P(EveryMapping, IsDrawnInProportionToWhatIsSeen) {
  for (const int height : {1, 2, 5, 8}) {
    Random random(static_cast<std::uint64_t>(height));
    const int width = width_of(GetParam(), height);
    const TextureImage image = image_of(width, height, [&](int x, int y) {
      return x == 1 && y == height / 2 ? 1e6 : random.below(4) == 0 ? 0 : random.log_between(1e-1, 1e1);
    });
    const SphereDistribution distribution(image, GetParam());
    constexpr int draws = 200'000;
    const int columns = 2 * width, rows = 2 * height;
    std::vector<double> expected, observed(static_cast<std::size_t>(columns * rows));
    double total = 0;
    for (int y = 0; y < rows; ++y)
      for (int x = 0; x < columns; ++x) {
        const Box2d cell{static_cast<double>(x) / columns, (x + 1.0) / columns, static_cast<double>(y) / rows,
                         (y + 1.0) / rows};
        const double mass = integral<3>(cell, [&](double u, double v) {
          const Vec3 d = direction_of(GetParam(), Vec2(glm::dvec2(u, v)));
          return distribution.pdf(d) * static_cast<double>(stretch_at(GetParam(), d));
        });
        expected.push_back(draws * mass);
        total += mass;
      }
    EXPECT_NEAR(total, 1, 1e-5);
    for (int i = 0; i < draws; ++i) {
      const Vec3 d = distribution.sample(random.square());
      ASSERT_NEAR(glm::length(d), 1, 1e-6);
      const Vec2 square = square_of(GetParam(), d);
      const int x = std::min(static_cast<int>(square.x * static_cast<float>(columns)), columns - 1);
      const int y = std::min(static_cast<int>(square.y * static_cast<float>(rows)), rows - 1);
      ++observed[static_cast<std::size_t>(y * columns + x)];
      EXPECT_GT(distribution.pdf(d), 0);
    }
    EXPECT_GT(chi_square(observed, expected).p, 1e-4) << height << " rows";
  }
}

INSTANTIATE_TEST_SUITE_P(, EveryMapping,
                         testing::Values(SphereMapping::equirectangular, SphereMapping::equal_area),
                         [](const auto& test) {
                           return std::string(
                               EnumNames<SphereMapping>::names[static_cast<std::size_t>(test.param)]);
                         });

// r = √(1 − |z|), φ spread over the edge; rows of the picture go down.
TEST(EqualArea, LiesInItsSquareAsPublished) {
  const auto expect = [](Vec2 picture, const Vec3& d) {
    const Vec3 found =
        transpose(frame_of_equal_area) * direction_of(SphereMapping::equal_area, {picture.x, 1 - picture.y});
    EXPECT_LT(glm::length(found - d), 1e-6f) << picture.x << ' ' << picture.y;
  };
  expect({0.5f, 0.5f}, {0, 0, 1});
  expect({0, 0}, {0, 0, -1});
  expect({1, 1}, {0, 0, -1});
  expect({1, 0.5f}, {1, 0, 0});
  expect({0.5f, 1}, {0, 1, 0});
  expect({0.75f, 0.5f}, {std::sqrt(0.4375f), 0, 0.75f});
  expect({0.75f, 0.75f}, {std::sqrt(0.5f), std::sqrt(0.5f), 0});
  expect({0.875f, 0.875f}, {std::sqrt(0.4375f / 2), std::sqrt(0.4375f / 2), -0.75f});
}

// An equirectangular picture as the usual tool turns it into the other one: texel by texel, polar angle and azimuth of
// Clarberg's axes over π and 2π.
TEST(EqualArea, LooksAsTheEquirectangularImageItWasMadeOf) {
  const auto value = [](double s, double t) { return 2 + std::sin(2 * pi_d * s) * std::sin(pi_d * t) + t; };
  const TextureImage wide =
      image_of(512, 256, [&](int x, int y) { return value((x + 0.5) / 512, 1 - (y + 0.5) / 256); });
  const TextureImage square = image_of(256, 256, [&](int x, int y) {
    const Vec3 d = transpose(frame_of_equal_area) *
                   direction_of(SphereMapping::equal_area, Vec2((static_cast<float>(x) + 0.5f) / 256,
                                                                (static_cast<float>(y) + 0.5f) / 256));
    const double azimuth = std::atan2(d.y, d.x);
    return value((azimuth < 0 ? azimuth + 2 * pi_d : azimuth) / (2 * pi_d), std::acos(d.z) / pi_d);
  });
  Random random(5);
  for (int i = 0; i < 10'000; ++i) {
    const Vec3 d(random.direction());
    EXPECT_NEAR(seen_along(square, SphereMapping::equal_area, d).r,
                seen_along(wide, SphereMapping::equirectangular, d).r, 0.02);
  }
}

}  // namespace
}  // namespace umbral
