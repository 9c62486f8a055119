// Opacity: the share of rays that pass, masks, and layers that decide for themselves.
#include <gtest/gtest.h>

#include "worlds.h"

namespace umbral {
namespace {

using namespace test;

// Whether `hits` of n is what probability p gives: within 4.5 standard deviations.
void expect_share(int hits, int n, double p) {
  EXPECT_NEAR(hits, n * p, 4.5 * std::sqrt(n * p * (1 - p)) + 1e-9);
}

SceneDescription with_alpha(ShapeKinds kind, float alpha, bool instanced) {
  SceneDescription scene = world_of(std::move(kind), {}, instanced);
  scene.materials[0].alpha.value = alpha;
  return scene;
}

Ray down_onto(Random& random, double reach) {
  const Vec2 target = (random.square() * 2.0f - 1.0f) * static_cast<float>(reach);
  const Vec3 origin(random.in_cube(1) + Vec3d(0, 0, 5));
  return {origin, Vec3(target, 0) - origin};
}

class Alpha : public testing::TestWithParam<bool> {};
INSTANTIATE_TEST_SUITE_P(Of, Alpha, testing::Bool(),
                         [](const auto& way) { return way.param ? "Instances" : "TheWorld"; });

TEST_P(Alpha, IsTheShareOfRaysThatMeetTheSurface) {
  for (const float alpha : {0.0f, 0.01f, 0.3f, 0.5f, 0.99f, 1.0f})
    for (const ShapeKinds& kind : {ShapeKinds(rectangle({-1, -1, 0}, {2, 0, 0}, {0, 2, 0})),
                                   ShapeKinds(disk({0, 0, 0}, {0, 0, 1}, 2))}) {
      Random random(1);
      const Scene scene(with_alpha(kind, alpha, GetParam()));
      constexpr int n = 50'000;
      int hits = 0;
      for (int i = 0; i < n; ++i) {
        const Ray ray = down_onto(random, 0.99);
        const bool is_hit = scene.intersect(ray).has_value();
        EXPECT_EQ(scene.occluded(ray), is_hit) << "the same ray meets the same fate";
        hits += is_hit;
      }
      expect_share(hits, n, alpha);
    }
}

// Through a sphere or a torus: each wall decides for itself.
TEST_P(Alpha, IsAskedAgainAtEveryWall) {
  constexpr float alpha = 0.4f;
  Random random(2);
  const Scene scene(with_alpha(sphere({0, 0, 0}, 1), alpha, GetParam()));
  constexpr int n = 50'000;
  int front = 0, back = 0;
  for (int i = 0; i < n; ++i) {
    const Ray ray = down_onto(random, 0.3);
    const auto surface = seen(scene, ray);
    if (!surface) continue;
    (dot(surface->ng, ray.d) < 0 ? front : back) += 1;
  }
  expect_share(front, n, alpha);
  expect_share(back, n, (1 - alpha) * alpha);

  const Scene ring(with_alpha(torus(1, 0.4f), alpha, GetParam()));
  int through = 0;
  for (int i = 0; i < n; ++i) {
    // Across the tube: two walls.
    const double phi = random.between(0, 2 * pi_d);
    const Vec3 target(Vec3d(std::cos(phi), std::sin(phi), 0) + random.in_cube(0.1));
    through += !ring.occluded({target + Vec3(0, 0, 5), {0, 0, -1}});
  }
  expect_share(through, n, (1 - alpha) * (1 - alpha));
}

TEST_P(Alpha, OfATextureMasksExactly) {
  SceneDescription description = world_of(rectangle({0, 0, 0}, {1, 0, 0}, {0, 1, 0}), {}, GetParam());
  CheckerTexture checker;
  checker.even = grey(1);
  checker.odd = grey(0);
  checker.uv_scale = {4, 4};
  const TextureId mask = add_texture(description, checker);
  description.materials[0].alpha.map = mask;
  const Scene scene(std::move(description));
  Random random(3);
  for (int i = 0; i < 20'000; ++i) {
    const Vec2 uv = random.square();
    const Vec2 square = uv * 4.0f;
    if (std::min({square.x - std::floor(square.x), std::ceil(square.x) - square.x,
                  square.y - std::floor(square.y), std::ceil(square.y) - square.y}) < 1e-4f)
      continue;
    const bool opaque = (static_cast<int>(square.x) + static_cast<int>(square.y)) % 2 == 0;
    const Vec3 origin(random.in_cube(1) + Vec3d(0, 0, 2));
    EXPECT_EQ(scene.intersect({origin, Vec3(uv, 0) - origin}).has_value(), opaque);
  }
}

// Layers under parallel light, as from the sun straight above: what passes the first is no reason to pass the next.
TEST(Alpha, OfLayersIsIndependentEvenForParallelRays) {
  for (const bool instanced : {false, true})
    for (const ShapeKinds& kind : {ShapeKinds(rectangle({-1, -1, 0}, {2, 0, 0}, {0, 2, 0})),
                                   ShapeKinds(disk({0, 0, 0}, {0, 0, 1}, 1))}) {
      SceneDescription description;
      add_matte(description, grey(0.5f));
      description.materials[0].alpha.value = 0.5f;
      Shape sheet;
      sheet.kind = kind;
      sheet.material = static_cast<MaterialId>(0);
      if (instanced) description.objects.push_back({"", {sheet}});
      for (int layer = 0; layer < 3; ++layer) {
        const Affine place = translation({0, 0, layer});
        if (instanced) {
          description.instances.push_back({static_cast<ObjectId>(0), place});
        } else {
          sheet.to_world = place;
          description.shapes.push_back(sheet);
        }
      }
      const Scene scene(std::move(description));
      Random random(4);
      constexpr int n = 40'000;
      int passed = 0;
      for (int i = 0; i < n; ++i) {
        const Vec2 p = (random.square() * 2.0f - 1.0f) * 0.7f;
        passed += !scene.occluded({{p, 5}, {0, 0, -1}});
      }
      expect_share(passed, n, 0.125);
    }
}

TEST(Alpha, DecidesTheSameInAWorldOfAnotherSize) {
  for (const ShapeKinds& kind :
       {ShapeKinds(rectangle({-1, -1, 0}, {2, 0, 0}, {0, 2, 0})), ShapeKinds(sphere({0, 0, 0}, 1))}) {
    SceneDescription small = with_alpha(kind, 0.5f, false), large = with_alpha(kind, 0.5f, false);
    large.shapes[0].to_world = scaling(Vec3d(0x1p20));
    const Scene a(std::move(small)), b(std::move(large));
    Random random(5);
    for (int i = 0; i < 5000; ++i) {
      const Ray ray = down_onto(random, 0.9);
      EXPECT_EQ(a.occluded(ray), b.occluded({ray.o * 0x1p20f, ray.d}));
    }
  }
}

}  // namespace
}  // namespace umbral
