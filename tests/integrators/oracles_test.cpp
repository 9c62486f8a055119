// The closed forms that the tests rely on, against brute-force integration over directions.
#include "support/oracles.h"

#include <gtest/gtest.h>

#include <functional>

namespace umbral::test {
namespace {

const Vec3d origin(0, 0, 0), up(0, 0, 1);

// (1/π) ∫ visible(ω) cos θ dω over the hemisphere, by the midpoint rule in (cos² θ, φ).
double brute_force(const std::function<bool(const Vec3d&)>& visible) {
  constexpr int n = 1500;
  int seen = 0;
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < n; ++j) {
      const double c2 = (i + 0.5) / n, phi = 2 * pi_d * (j + 0.5) / n, s = std::sqrt(1 - c2);
      seen += visible({s * std::cos(phi), s * std::sin(phi), std::sqrt(c2)});
    }
  return static_cast<double>(seen) / (n * n);
}

TEST(ClosedForm, SphereIsWhatQuadratureSays) {
  for (const Vec3d& center : {Vec3d(0.3, 0.2, 1.6), Vec3d(1.5, 0.1, 0.4), Vec3d(1.5, 0.4, -0.5)}) {
    const auto seen = [&](const Vec3d& d) {
      const double b = dot(center, d);
      return b > 0 && b * b >= dot(center, center) - 1;
    };
    EXPECT_NEAR(sphere_form_factor(origin, up, center, 1), brute_force(seen), 2e-4);
  }
  EXPECT_EQ(sphere_form_factor(origin, up, {0, 0, -2}, 1), 0);
}

TEST(ClosedForm, PolygonIsWhatQuadratureSays) {
  const std::vector<Vec3d> triangle{{1, -1, -0.7}, {1.5, 1.5, 0.3}, {0.8, 0.2, 2}};
  const auto seen = [&](const Vec3d& d) {
    bool within = true;  // of the three planes through the origin and an edge
    for (int i = 0; i < 3; ++i) within &= dot(cross(triangle[i], triangle[(i + 1) % 3]), d) > 0;
    return within;
  };
  EXPECT_NEAR(polygon_form_factor(origin, up, triangle), brute_force(seen), 2e-4);
}

TEST(ClosedForm, DiskIsAPolygonOfManyCorners) {
  std::vector<Vec3d> corners;
  for (int i = 0; i < 2000; ++i) {
    const double phi = 2 * pi_d * i / 2000;
    corners.push_back({0.7 + 0.5 * std::cos(phi), 0.5 * std::sin(phi), 0.8});
  }
  EXPECT_NEAR(disk_form_factor(0.8, 0.7, 0.5), polygon_form_factor(origin, up, corners), 2e-6);
  EXPECT_NEAR(disk_form_factor(0.8, 0, 0.5), 0.25 / 0.89, 1e-15);
}

}  // namespace
}  // namespace umbral::test
