// Shadow rays: they arrive at the light and end there, blocked by what is between and by nothing else.
#include <gtest/gtest.h>

#include "worlds.h"

namespace umbral {
namespace {

using namespace test;

constexpr LightId light{0};

// A floor below a light, turned, scaled and moved together. `sheet_height` < 0: nothing between; else a thin sheet
// there, between the floor at 0 and the light at 1 and above. An instanced light is moved away within its object
// and back by its place.
SceneDescription stage(const ShapeKinds& emitter, const Affine& place, double sheet_height,
                       bool instanced = false) {
  SceneDescription description;
  const MaterialId matte = add_matte(description, grey(0.5f));
  add_shape(description, rectangle({-1, -1, 0}, {2, 0, 0}, {0, 2, 0}), matte).to_world = place;
  if (sheet_height >= 0)
    add_shape(description, rectangle({-5, -5, 0}, {10, 0, 0}, {0, 10, 0}), matte).to_world =
        place * translation({0, 0, sheet_height});
  Shape& lamp = add_shape(description, emitter, matte, grey(1));
  lamp.to_world = place;
  if (!instanced) return description;
  const Vec3d away(7, -5, 3);
  lamp.to_world = translation(away);
  description.objects.push_back({"", {std::move(lamp)}});
  description.shapes.pop_back();
  description.instances.push_back({static_cast<ObjectId>(0), place * translation(-away)});
  return description;
}

// Of the shadow rays from points of the floor: how many of how many are blocked.
std::pair<int, int> blocked(const Scene& scene, const Affine& place, Random& random, int rays) {
  int blocked = 0, total = 0;
  for (int i = 0; i < rays; ++i) {
    const Vec3d target = place.point({random.between(-0.95, 0.95), random.between(-0.95, 0.95), 0});
    // Seen from below, where nothing is in the way; the ray then leaves from the other side.
    const Vec3d below = place.point({random.between(-0.5, 0.5), random.between(-0.5, 0.5), -1});
    const Ray ray{Vec3(below), Vec3(target - below)};
    const auto hit = scene.intersect(ray);
    if (!hit || hit->geometry != 0 || hit->instance != no_index) continue;
    const Surface floor = scene.surface(ray, *hit);
    const auto sample = scene.sample_light(light, floor.p, random.square());
    if (!sample) continue;
    ++total;
    blocked += scene.occluded(Scene::shadow_ray(floor, *sample));
  }
  EXPECT_GT(total, rays / 5);
  return {blocked, total};
}

std::vector<std::pair<const char*, ShapeKinds>> emitters() {
  Mesh tilted = polygon({{-0.5f, -0.5f, 1.5f}, {0.5f, 0.5f, 1.2f}, {0.5f, -0.5f, 1.2f}});
  return {{"rectangle", rectangle({-0.5f, -0.5f, 1.5f}, {0, 1, 0}, {1, 0, 0})},
          {"disk", disk({0, 0, 1.5f}, {0, 0, -1}, 0.5f)},
          {"sphere", sphere({0, 0, 1.6f}, 0.5f)},
          {"box", box({-0.4f, -0.4f, 1.2f}, {0.4f, 0.4f, 1.9f})},
          {"mesh", tilted}};
}

Affine any_place(Random& random) {
  const double scale = std::pow(10, random.between(-4, 4));
  const Affine stretched = random_affine(random, 0.5, 2, 0);
  const Affine proper = stretched.determinant() > 0 ? stretched : stretched * scaling({1, -1, 1});
  return translation(random.in_cube(scale * std::pow(10, random.between(-2, 1)))) * scaling(Vec3d(scale)) *
         proper;
}

TEST(ShadowRay, ReachesEveryPartOfALightThatIsSeen) {
  for (const auto& [name, emitter] : emitters()) {
    SCOPED_TRACE(name);
    Random random(1);
    int all = 0;
    for (int i = 0; i < 120; ++i) {
      const Affine place = any_place(random);
      const Scene scene(stage(emitter, place, -1, i % 2 == 1));
      all += blocked(scene, place, random, 300).first;
    }
    EXPECT_EQ(all, 0) << "blocked by the floor it leaves or the light it goes to";
  }
}

TEST(ShadowRay, IsStoppedByAThinSheetBetween) {
  for (const auto& [name, emitter] : emitters()) {
    SCOPED_TRACE(name);
    Random random(2);
    for (const double height : {1e-3, 0.5, 0.999}) {
      const Affine place = random_affine(random, 0.9, 1.1, 1);
      const Scene scene(stage(emitter, place, height, height == 0.5));
      const auto [stopped, total] = blocked(scene, place, random, 3000);
      EXPECT_EQ(stopped, total) << "sheet at " << height;
    }
  }
}

TEST(ShadowRay, IsNotStoppedByWhatIsBehindTheLight) {
  for (const auto& [name, emitter] : emitters()) {
    SCOPED_TRACE(name);
    Random random(3);
    const Affine place = random_affine(random, 0.9, 1.1, 1);
    const Scene scene(stage(emitter, place, 2.2));
    EXPECT_EQ(blocked(scene, place, random, 3000).first, 0);
  }
}

// A sheet that nearly touches the light, or lies upon the floor, still casts its shadow.
TEST(ShadowRay, IsStoppedByASheetThatNearlyTouches) {
  Random random(4);
  const ShapeKinds lamp = rectangle({-0.5f, -0.5f, 1.5f}, {0, 1, 0}, {1, 0, 0});
  for (const double height : {1e-4, 1.5 - 1e-4}) {
    const Affine place = random_similarity(random, 1, 1);
    const Scene scene(stage(lamp, place, height));
    const auto [stopped, total] = blocked(scene, place, random, 3000);
    EXPECT_EQ(stopped, total) << "sheet at " << height;
  }
}

TEST(ShadowRay, GoesToPointLightsAndEndsThere) {
  SceneDescription description = world_of(rectangle({-1, -1, 0}, {2, 0, 0}, {0, 2, 0}), {}, false);
  add_shape(description, rectangle({-1, -1, 2}, {2, 0, 0}, {0, 2, 0}), static_cast<MaterialId>(0));
  description.lights.emplace_back(PointLight{{0, 0, 1}, grey(1)});
  description.lights.emplace_back(PointLight{{0, 0, 3}, grey(1)});
  description.lights.emplace_back(DistantLight{{0, 0, -1}, grey(1)});
  description.lights.emplace_back(DistantLight{{0, 0, 1}, grey(1)});
  const Scene scene(std::move(description));
  const Ray ray{{0.1f, 0.2f, 1.5f}, {0, 0, -1}};
  const Surface floor = *seen(scene, ray);
  const auto is_shadowed = [&](std::uint32_t i) {
    return scene.occluded(
        Scene::shadow_ray(floor, *scene.sample_light(static_cast<LightId>(i), floor.p, {0.5f, 0.5f})));
  };
  EXPECT_FALSE(is_shadowed(0)) << "the ceiling is beyond the lamp";
  EXPECT_TRUE(is_shadowed(1)) << "the ceiling is between";
  EXPECT_TRUE(is_shadowed(2)) << "the sun is above the ceiling";
  EXPECT_FALSE(is_shadowed(3)) << "and this one below the floor, where the ray leaves on the other side";
}

TEST(ShadowRay, StartsOnTheSideOfTheLight) {
  const Scene scene(world_of(rectangle({-1, -1, 5}, {2, 0, 0}, {0, 2, 0}), {}, false));
  const Ray ray{{0, 0, 9}, {0, 0, -1}};
  const Surface surface = *seen(scene, ray);
  for (const float side : {1.0f, -1.0f}) {
    const LightSample sample{{0, 0, side}, white, 1, true, infinity, {}};
    const Ray shadow = Scene::shadow_ray(surface, sample);
    EXPECT_GT((shadow.o.z - surface.p.z) * side, 0);
    EXPECT_EQ(shadow.d, sample.wi);
    EXPECT_EQ(shadow.t_max, infinity);
  }
}

}  // namespace
}  // namespace umbral
