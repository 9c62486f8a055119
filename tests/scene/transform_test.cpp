// Affine maps: rotations by the right hand, inverses, normals and areas.
#include "scene/transform.h"

#include <gtest/gtest.h>

#include "affine_examples.h"

namespace umbral {
namespace {

using test::random_affine, test::Random;

void expect_near(const Vec3d& a, const Vec3d& b, double tolerance) {
  EXPECT_LT(glm::length(a - b), tolerance);
}

TEST(Rotation, TurnsByTheRightHand) {
  const Vec3d x(1, 0, 0), y(0, 1, 0), z(0, 0, 1);
  expect_near(rotation(z, pi_d / 2).point(x), y, 1e-15);
  expect_near(rotation(x, pi_d / 2).point(y), z, 1e-15);
  expect_near(rotation(y, pi_d / 2).point(z), x, 1e-15);
  expect_near(rotation(z, pi_d / 6).point(x), {std::sqrt(3.0) / 2, 0.5, 0}, 1e-15);
}

TEST(Rotation, KeepsItsAxisLengthsAndOrientation) {
  Random random(1);
  for (int i = 0; i < 1000; ++i) {
    const Vec3d axis = random.direction(), v = random.in_cube(1);
    const double a = random.between(-7, 7), b = random.between(-7, 7);
    const Affine turn = rotation(axis, a);
    expect_near(turn.point(axis), axis, 1e-14);
    EXPECT_NEAR(glm::length(turn.point(v)), glm::length(v), 1e-14);
    EXPECT_NEAR(turn.determinant(), 1, 1e-14);
    expect_near((rotation(axis, b) * turn).point(v), rotation(axis, a + b).point(v), 1e-14);
    // The angle, seen on a vector square to the axis.
    const Vec3d across = glm::normalize(cross(axis, random.direction()));
    EXPECT_NEAR(dot(turn.point(across), across), std::cos(a), 1e-14);
    EXPECT_NEAR(dot(turn.point(across), cross(axis, across)), std::sin(a), 1e-14);
  }
}

TEST(Affine, AppliesTheInnerMapFirst) {
  const Affine map = translation({10, 0, 0}) * rotation({0, 0, 1}, pi_d / 2) * scaling({2, 3, 4});
  expect_near(map.point({1, 1, 1}), {10 - 3, 2, 4}, 1e-14);
  expect_near(map.vector({1, 1, 1}), {-3, 2, 4}, 1e-14);
  EXPECT_NEAR(map.determinant(), 24, 1e-13);
}

TEST(Affine, IsUndoneByItsInverse) {
  Random random(2);
  for (int i = 0; i < 1000; ++i) {
    const Affine map = random_affine(random, 0.1, 10, 100);
    const Vec3d p = random.in_cube(10);
    expect_near(inverse(map).point(map.point(p)), p, 1e-10);
    expect_near(map.point(inverse(map).point(p)), p, 1e-10);
  }
}

TEST(Affine, KnowsTheIdentity) {
  EXPECT_TRUE(Affine{}.is_identity());
  EXPECT_TRUE(scaling({1, 1, 1}).is_identity());
  EXPECT_FALSE(translation({0, 1e-300, 0}).is_identity());
  EXPECT_FALSE(scaling({1, -1, 1}).is_identity());
}

TEST(Affine, CarriesNormalsSquareToTangentsAndToTheSameSide) {
  Random random(3);
  for (int i = 0; i < 1000; ++i) {
    const Affine map = random_affine(random, 0.1, 10, 100);
    const Vec3d n = random.direction();
    const Vec3d t = glm::normalize(cross(n, random.direction())), b = cross(n, t);
    const Vec3d moved = glm::normalize(inverse(map).transposed(n));
    EXPECT_NEAR(dot(moved, glm::normalize(map.vector(t))), 0, 1e-12);
    EXPECT_NEAR(dot(moved, glm::normalize(map.vector(b))), 0, 1e-12);
    EXPECT_GT(dot(moved, map.vector(n)), 0) << "mirrored or not";
  }
}

TEST(AreaStretch, IsTheGrowthOfAParallelogram) {
  Random random(4);
  for (int i = 0; i < 1000; ++i) {
    const Affine map = random_affine(random, 0.1, 10, 100);
    const Vec3d n = random.direction();
    const Vec3d t = glm::normalize(cross(n, random.direction())), b = cross(n, t);
    const double area = glm::length(cross(map.vector(t), map.vector(b)));
    EXPECT_NEAR(area_stretch(map, inverse(map), n) / area, 1, 1e-11);
  }
  const Affine flat = scaling({2, 3, 5});
  EXPECT_NEAR(area_stretch(flat, inverse(flat), {0, 0, 1}), 6, 1e-13);
  EXPECT_NEAR(area_stretch(flat, inverse(flat), {1, 0, 0}), 15, 1e-13);
}

}  // namespace
}  // namespace umbral
