// Frames and small functions.
#include "core/math.h"

#include <gtest/gtest.h>

#include "chi_square.h"
#include "core/warp.h"

namespace umbral {
namespace {

// To 8 roundings of a float.
void expect_orthonormal(const Frame& f, const Vec3& n, double tolerance = 0x1p-20) {
  EXPECT_NEAR(length(Vec3d(f.s)), 1, tolerance);
  EXPECT_NEAR(length(Vec3d(f.t)), 1, tolerance);
  EXPECT_NEAR(dot(Vec3d(f.s), Vec3d(f.t)), 0, tolerance);
  EXPECT_NEAR(dot(Vec3d(f.s), Vec3d(n)), 0, tolerance);
  EXPECT_NEAR(dot(Vec3d(f.t), Vec3d(n)), 0, tolerance);
  EXPECT_EQ(f.n, n);
  EXPECT_NEAR(dot(cross(f.s, f.t), f.n), 1, tolerance) << "right-handed";
}

TEST(Frame, IsOrthonormalAroundAnyNormal) {
  test::Uniform random(1);
  for (int i = 0; i < 20'000; ++i) {
    const Vec3 n = square_to_sphere(random.next2());
    expect_orthonormal(frame_from_normal(n), n);
  }
  for (const Vec3 n :
       {Vec3(0, 0, 1), Vec3(0, 0, -1), Vec3(1, 0, 0), Vec3(0, -1, 0), Vec3(0, 0, -0.0f) + Vec3(1, 0, 0),
        normalize(Vec3(1e-4f, 0, -1)), normalize(Vec3(0, 1e-20f, -1))})
    expect_orthonormal(frame_from_normal(n), n);
}

TEST(Frame, FollowsTheTangentAndSurvivesAParallelOne) {
  test::Uniform random(2);
  for (int i = 0; i < 20'000; ++i) {
    const Vec3 n = square_to_sphere(random.next2());
    const Vec3 tangent = 1e3f * square_to_sphere(random.next2());
    const float sine = length(cross(n, tangent)) / 1e3f;
    if (sine < 0.1f) continue;
    const Frame frame = frame_from_normal_and_tangent(n, tangent);
    expect_orthonormal(frame, n, 0x1p-20 / sine);
    EXPECT_NEAR(dot(frame.t, tangent), 0, 2e-3f);
    EXPECT_GT(dot(frame.s, tangent), 0);
  }
  for (const Vec3 tangent : {Vec3(0), Vec3(0, 5, 0), Vec3(0, -1e-20f, 0), Vec3(std::nanf(""), 0, 0)})
    expect_orthonormal(frame_from_normal_and_tangent({0, 1, 0}, tangent), {0, 1, 0});
}

TEST(Frame, GoesThereAndBack) {
  const Frame frame = frame_from_normal(normalize(Vec3(1, 2, 3)));
  const Vec3 v{0.3f, -4, 5};
  EXPECT_LT(length(frame.to_world(frame.to_local(v)) - v), 2e-6f);
  EXPECT_FLOAT_EQ(frame.to_local(frame.n).z, 1);
}

TEST(Math, SafeSqrtAndFinite) {
  EXPECT_EQ(safe_sqrt(-1e-9f), 0);
  EXPECT_EQ(safe_sqrt(4), 2);
  EXPECT_TRUE(is_finite(Vec3(1, 2, 3)));
  EXPECT_FALSE(is_finite(Vec3(1, infinity, 3)));
  EXPECT_FALSE(is_finite(Vec3(std::nanf(""), 2, 3)));
  EXPECT_FALSE(is_finite(Vec2(1, -infinity)));
  EXPECT_EQ(max_component(Vec3(1, 7, 3)), 7);
  EXPECT_LT(one_minus_epsilon, 1);
  EXPECT_EQ(std::nextafter(one_minus_epsilon, 2.0f), 1);
}

}  // namespace
}  // namespace umbral
