// Materials whose inner side is not as the outer one, and opacities that are cut off.
#include <gtest/gtest.h>

#include "worlds.h"

namespace umbral {
namespace {

using namespace test;

class Sides : public testing::TestWithParam<bool> {};
INSTANTIATE_TEST_SUITE_P(Of, Sides, testing::Bool(),
                         [](const auto& way) { return way.param ? "Instances" : "TheWorld"; });

std::vector<ShapeKinds> shapes() {
  return {rectangle({-1, -1, 0}, {2, 0, 0}, {0, 2, 0}), disk({0, 0, 0}, {0, 0, 1}, 1), sphere({0, 0, 0}, 1),
          icosphere(2), torus(1, 0.4f)};
}

std::vector<Affine> places() {
  return {Affine{}, scaling({-1, 1, 1}),
          translation({1, 2, 3}) * scaling({2, 0.5, -1})};  // two of them mirror
}

TEST_P(Sides, ClearOnesLetEveryRayFromBehindPass) {
  for (const ShapeKinds& kind : shapes())
    for (const Affine& place : places()) {
      SceneDescription two = world_of(kind, place, GetParam()), one = world_of(kind, place, GetParam());
      one.materials[0].back = BackSide::clear;
      const Scene both(std::move(two)), front(std::move(one));
      Random random(1);
      int met = 0, passed = 0;
      for (int i = 0; i < 2000; ++i) {
        const Vec3d to = random.in_cube(0.9), from = random.in_cube(1) + Vec3d(0, 0, i % 2 == 0 ? 5 : -5);
        const Ray ray{Vec3(place.point(from)), Vec3(place.vector(to - from))};
        const auto expected = seen(both, ray), surface = seen(front, ray);
        if (!expected) {
          EXPECT_FALSE(surface);
          continue;
        }
        const bool behind = dot(expected->ng, ray.d) > 0;
        met += !behind;
        passed += behind;
        if (surface) {
          EXPECT_LT(dot(surface->ng, ray.d), 0);
        }
        if (!behind) {
          ASSERT_TRUE(surface);
          EXPECT_EQ(surface->p, expected->p);
        }
        EXPECT_EQ(front.occluded(ray), surface.has_value());
      }
      EXPECT_GT(met, 100);
      const bool is_flat = std::holds_alternative<Rectangle>(kind) || std::holds_alternative<Disk>(kind);
      if (is_flat) {
        EXPECT_GT(passed, 100);
      }
    }
}

// From inside a closed shape with clear walls one sees out.
TEST_P(Sides, ClearOnesAreNotThereFromInside) {
  for (const ShapeKinds& kind : {ShapeKinds(sphere({0, 0, 0}, 1)), ShapeKinds(icosphere(1))}) {
    SceneDescription description = world_of(kind, {}, GetParam());
    description.materials[0].back = BackSide::clear;
    const Scene scene(std::move(description));
    Random random(2);
    for (int i = 0; i < 500; ++i) {
      const Ray ray{Vec3(random.in_cube(0.3)), Vec3(random.direction())};
      EXPECT_FALSE(scene.intersect(ray));
      EXPECT_FALSE(scene.occluded(ray));
    }
  }
}

TEST_P(Sides, BlackOnesReflectNothingAndStillStand) {
  SceneDescription description = world_of(rectangle({-1, -1, 0}, {2, 0, 0}, {0, 2, 0}), {}, GetParam());
  description.materials[0].back = BackSide::absorbing;
  const Scene scene(std::move(description));
  const Ray down{{0.1f, 0.2f, 1}, {0, 0, -1}}, up{{0.1f, 0.2f, -1}, {0, 0, 1}};
  LobeStack room;
  EXPECT_EQ(albedo(scene.bsdf(*seen(scene, down), room)), grey(0.5f));
  EXPECT_EQ(albedo(scene.bsdf(*seen(scene, up), room)), black);
  EXPECT_TRUE(scene.occluded(up));
}

// A lamp whose inner side is not there does not shine from there either.
TEST_P(Sides, ClearOnesEmitOutwardsAlone) {
  SceneDescription description =
      world_of(rectangle({-1, -1, 0}, {2, 0, 0}, {0, 2, 0}), {}, GetParam(), grey(1));
  (GetParam() ? description.objects[0].shapes[0] : description.shapes[0]).two_sided = true;
  description.materials[0].back = BackSide::clear;
  const Scene scene(std::move(description));
  EXPECT_TRUE(scene.sample_light(static_cast<LightId>(0), {0, 0, 1}, {0.5f, 0.5f}));
  EXPECT_FALSE(scene.sample_light(static_cast<LightId>(0), {0, 0, -1}, {0.5f, 0.5f}));
}

TEST_P(Sides, MasksAreCutOff) {
  for (const float alpha : {0.0f, 0.29f, 0.3f, 0.7f, 1.0f}) {
    SceneDescription description = world_of(rectangle({-1, -1, 0}, {2, 0, 0}, {0, 2, 0}), {}, GetParam());
    description.materials[0].alpha.value = alpha;
    description.materials[0].alpha_mode = AlphaMode::mask;
    description.materials[0].alpha_cutoff = 0.3f;
    const Scene scene(std::move(description));
    Random random(3);
    for (int i = 0; i < 200; ++i) {
      const Vec3 from(random.in_cube(0.5) + Vec3d(0, 0, 2));
      const Ray ray{from, Vec3(random.in_cube(0.5)) * Vec3(1, 1, 0) - from};
      EXPECT_EQ(scene.intersect(ray).has_value(), alpha >= 0.3f) << alpha;
      EXPECT_EQ(scene.occluded(ray), alpha >= 0.3f) << alpha;
    }
  }
}

}  // namespace
}  // namespace umbral
