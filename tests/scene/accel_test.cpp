// Rays through Embree against brute force in double: triangles, instances, user geometry.
#include "scene/accel.h"

#include <gtest/gtest.h>

#include "worlds.h"

namespace umbral {
namespace {

using namespace test;

Mesh soup(Random& random, int triangles, double size) {
  Mesh mesh;
  for (int i = 0; i < triangles; ++i) {
    const Vec3d middle = random.in_cube(1);
    for (int k = 0; k < 3; ++k) mesh.positions.emplace_back(middle + random.in_cube(size));
    const auto first = static_cast<unsigned>(3 * i);
    mesh.triangles.push_back({first, first + 1, first + 2});
  }
  return mesh;
}

struct Crossing {
  double t;
  double margin;  // the smallest barycentric weight: how far inside the triangle
  std::uint32_t triangle;
};

// Möller and Trumbore [1997] in double; `slack` lets triangles reach beyond their edges.
std::optional<Crossing> first_crossing(const Mesh& mesh, const Ray& ray, double slack) {
  std::optional<Crossing> first;
  const Vec3d o(ray.o), d(ray.d);
  for (std::uint32_t i = 0; i < mesh.triangles.size(); ++i) {
    const glm::uvec3& t = mesh.triangles[i];
    const Vec3d a(mesh.positions[t.x]), e(Vec3d(mesh.positions[t.y]) - a), f(Vec3d(mesh.positions[t.z]) - a);
    const Vec3d p = cross(d, f), s = o - a, q = cross(s, e);
    const double det = dot(e, p), u = dot(s, p) / det, v = dot(d, q) / det, distance = dot(f, q) / det;
    const double margin = std::min({u, v, 1 - u - v});
    if (!(margin >= -slack) || distance <= ray.t_min || distance >= ray.t_max) continue;
    if (!first || distance < first->t) first = {distance, margin, i};
  }
  return first;
}

Ray random_ray(Random& random, double reach) {
  const Vec3 origin(random.in_cube(reach));
  const Vec3 target(random.in_cube(1));
  return {origin, (target - origin) * static_cast<float>(random.log_between(0.1, 10))};
}

TEST(Accel, FindsWhatBruteForceFindsInRandomTriangles) {
  Random random(1);
  int hits = 0, compared = 0;
  for (int scene_number = 0; scene_number < 20; ++scene_number) {
    const Mesh mesh = soup(random, 200, scene_number % 2 == 0 ? 0.1 : 0.5);
    const Scene scene(world_of(mesh, {}, false));
    for (int i = 0; i < 2000; ++i) {
      const Ray ray = random_ray(random, 2);
      // Rays that pass an edge within rounding may go either way: those on which slack changes the answer are left out.
      const auto expected = first_crossing(mesh, ray, 1e-4), strict = first_crossing(mesh, ray, -1e-4);
      if (expected.has_value() != strict.has_value() || (strict && strict->t != expected->t)) continue;
      ++compared;
      const auto hit = scene.intersect(ray);
      ASSERT_EQ(hit.has_value(), expected.has_value());
      EXPECT_EQ(scene.occluded(ray), expected.has_value());
      if (!hit) continue;
      ++hits;
      EXPECT_EQ(hit->primitive, expected->triangle);
      EXPECT_EQ(hit->instance, no_index);
      EXPECT_NEAR(hit->t, expected->t, 2e-4 * expected->t);
    }
  }
  EXPECT_GT(hits, 5000);
  EXPECT_GT(compared, 38'000) << "of 40 000";
}

// Whatever the interval, occluded() says what intersect() says, and both keep to it.
TEST(Accel, IsOccludedWhereItIsHit) {
  Random random(2);
  SceneDescription description = world_of(soup(random, 100, 0.3), {}, false);
  add_shape(description, sphere({0.3f, 0, 0}, 0.4f), static_cast<MaterialId>(0));
  add_shape(description, torus(0.8f, 0.1f), static_cast<MaterialId>(0));
  add_shape(description, disk({0, 0, 0.5f}, {1, 1, 1}, 0.5f), static_cast<MaterialId>(0));
  const Scene scene(std::move(description));
  int hits = 0;
  for (int i = 0; i < 30'000; ++i) {
    Ray ray = random_ray(random, 2);
    if (i % 3 > 0) ray.t_min = static_cast<float>(random.between(0, 1));
    if (i % 3 > 1) ray.t_max = ray.t_min + static_cast<float>(random.between(0, 1));
    const auto hit = scene.intersect(ray);
    EXPECT_EQ(scene.occluded(ray), hit.has_value());
    if (!hit) continue;
    ++hits;
    EXPECT_TRUE(hit->t >= ray.t_min && hit->t <= ray.t_max);
    ray.t_max = hit->t * 0.999f;
    const auto before = ray.t_max > ray.t_min ? scene.intersect(ray) : std::nullopt;
    EXPECT_TRUE(!before) << "something was nearer";
  }
  EXPECT_GT(hits, 8000);
}

TEST(Accel, MeetsInstancesAsItMeetsBakedCopies) {
  Random random(3);
  for (int scene_number = 0; scene_number < 20; ++scene_number) {
    const Mesh mesh = soup(random, 60, 0.4);
    const Affine place = random_affine(random, 0.3, 3, 5), back = inverse(place);
    const Scene instanced(world_of(mesh, place, true)), baked(world_of(mesh, place, false));
    for (int i = 0; i < 1000; ++i) {
      const Ray local = random_ray(random, 2);
      const Ray ray{Vec3(place.point(Vec3d(local.o))), Vec3(place.vector(Vec3d(local.d)))};
      const Ray seen_from_within{Vec3(back.point(Vec3d(ray.o))), Vec3(back.vector(Vec3d(ray.d)))};
      const auto expected = first_crossing(mesh, seen_from_within, 1e-3);
      const auto strict = first_crossing(mesh, seen_from_within, -1e-3);
      if (expected.has_value() != strict.has_value() || (strict && strict->t != expected->t)) continue;
      const auto a = instanced.intersect(ray), b = baked.intersect(ray);
      ASSERT_EQ(a.has_value(), b.has_value());
      ASSERT_EQ(a.has_value(), expected.has_value());
      if (!a) continue;
      EXPECT_EQ(a->instance, 0u);
      EXPECT_EQ(b->instance, no_index);
      EXPECT_EQ(a->primitive, b->primitive);
      EXPECT_NEAR(a->t, b->t, 1e-3 * b->t);
      const Surface x = instanced.surface(ray, *a), y = baked.surface(ray, *b);
      EXPECT_LT(glm::length(x.p - y.p), 1e-4);
      EXPECT_LT(glm::length(x.ng - y.ng), 1e-3);
    }
  }
}

template <class Analytic>
void expect_own_hits(const Analytic& shape, bool instanced, std::uint64_t seed) {
  Random random(seed);
  int hits = 0;
  for (int scene_number = 0; scene_number < 20; ++scene_number) {
    const Affine place = random_affine(random, 0.3, 3, 5);
    const Affine to_world = place * shape.placement(), from_world = inverse(to_world);
    const Scene scene(world_of(shape, place, instanced));
    for (int i = 0; i < 1000; ++i) {
      const Vec3 origin(to_world.point(random.in_cube(3))), target(to_world.point(random.in_cube(1.2)));
      const Ray ray{origin, target - origin};
      const Vec3d o = from_world.point(Vec3d(ray.o)), d = from_world.vector(Vec3d(ray.d));
      const auto expected = shape.intersect(o, d, 0, 1e30);
      const auto hit = scene.intersect(ray);
      if (expected.has_value() != hit.has_value()) {
        // Only a ray that grazes the outline within the rounding of a float may be seen otherwise by an instance.
        EXPECT_TRUE(instanced);
        const double t = expected ? *expected : static_cast<double>(hit->t);
        const Vec3d n = shape.nearest(o + t * d).n;
        const bool grazes = std::abs(dot(n, glm::normalize(d))) < 3e-3;
        EXPECT_TRUE(grazes || shape.nearest(o + t * d).uv.y > 0.9999) << "a miss";
        continue;
      }
      if (!hit) continue;
      ++hits;
      EXPECT_NEAR(hit->t, *expected, (instanced ? 1e-3 : 1e-7) * (1 + *expected));
    }
  }
  EXPECT_GT(hits, 3000);
}

TEST(Accel, MeetsAnalyticShapesWhereTheySayThemselves) {
  expect_own_hits(sphere({1, 2, 3}, 0.5f), false, 4);
  expect_own_hits(disk({1, 2, 3}, {3, 1, 2}, 2), false, 5);
  expect_own_hits(torus(1, 0.3f), false, 6);
  expect_own_hits(torus(1, 1.5f), false, 7);
}

TEST(Accel, MeetsInstancedAnalyticShapesWhereTheySayThemselves) {
  expect_own_hits(sphere({1, 2, 3}, 0.5f), true, 8);
  expect_own_hits(disk({1, 2, 3}, {3, 1, 2}, 2), true, 9);
  expect_own_hits(torus(1, 0.3f), true, 10);
}

TEST(Accel, SpeaksOfEachShapeByItsPlace) {
  SceneDescription description;
  const MaterialId matte = add_matte(description, grey(0.5f));
  add_shape(description, sphere({0, 0, 0}, 0.4f), matte);
  add_shape(description, rectangle({0.6f, -0.4f, 0}, {0.8f, 0, 0}, {0, 0.8f, 0}), matte);
  Shape part;
  part.material = matte;
  part.kind = disk({0, 0, 0}, {0, 0, 1}, 0.3f);
  Shape other = part;
  other.kind = box({0.6f, -0.3f, -0.3f}, {1.2f, 0.3f, 0.3f});
  description.objects.push_back({"", {part, other}});
  description.instances.push_back({static_cast<ObjectId>(0), translation({0, 3, 0})});
  description.instances.push_back({static_cast<ObjectId>(0), translation({0, 6, 0})});
  const Scene scene(std::move(description));
  const auto at = [&](float x, float y) { return *scene.intersect({{x, y, 5}, {0, 0, -1}}); };
  EXPECT_EQ(at(0, 0).geometry, 0u);
  EXPECT_EQ(at(0, 0).instance, no_index);
  EXPECT_EQ(at(1, 0).geometry, 1u);
  EXPECT_EQ(at(0, 3).instance, 0u);
  EXPECT_EQ(at(0, 3).geometry, 0u);
  EXPECT_EQ(at(0.9f, 6).instance, 1u);
  EXPECT_EQ(at(0.9f, 6).geometry, 1u);
}

TEST(Accel, CountsItsMemoryAndKnowsItsBounds) {
  Random random(11);
  const Scene small(world_of(soup(random, 10, 0.1), {}, false));
  const Scene large(world_of(soup(random, 100'000, 0.1), {}, false));
  EXPECT_GT(large.accel_bytes(), small.accel_bytes() + 1'000'000);
  const Scene ball(world_of(sphere({10, 0, 0}, 2), {}, true));
  EXPECT_NEAR(ball.radius(), 2 * std::sqrt(3.0), 1e-4) << "half the diagonal of its box";
}

TEST(Accel, BearsAnEmptyWorldAndEmptyObjects) {
  SceneDescription description;
  description.objects.push_back({"", {}});
  description.instances.push_back({static_cast<ObjectId>(0), Affine{}});
  const Scene scene(std::move(description));
  EXPECT_FALSE(scene.intersect({{0, 0, 0}, {0, 0, 1}}));
  EXPECT_FALSE(scene.occluded({{0, 0, 0}, {0, 0, 1}}));
  EXPECT_EQ(scene.radius(), 0);
  EXPECT_EQ(scene.light_count(), 0u);
  EXPECT_EQ(scene.choose_light(LightSelection::power, {}, 0.5f).light, LightId::none);
}

// The same world 2^k times as large, seen from 2^k as far, is the same to the last bit.
TEST(Accel, IsBlindToPowersOfTwo) {
  for (const int power : {-20, 20}) {
    Random random(12);
    const double factor = std::exp2(power);
    const Mesh mesh = soup(random, 100, 0.3);
    const auto world = [&](double scale) {
      SceneDescription description = world_of(mesh, scaling(Vec3d(scale)), false);
      add_shape(description, sphere({0.3f, 0.1f, 0}, 0.4f), static_cast<MaterialId>(0));
      add_shape(description, torus(0.8f, 0.1f), static_cast<MaterialId>(0));
      for (std::size_t i = 1; i < 3; ++i) description.shapes[i].to_world = scaling(Vec3d(scale));
      return description;
    };
    const Scene plain(world(1)), scaled(world(factor));
    int hits = 0;
    for (int i = 0; i < 10'000; ++i) {
      const Ray ray = random_ray(random, 2), far{ray.o * static_cast<float>(factor), ray.d};
      const auto a = plain.intersect(ray), b = scaled.intersect(far);
      ASSERT_EQ(a.has_value(), b.has_value());
      if (!a) continue;
      ++hits;
      EXPECT_EQ(a->t * static_cast<float>(factor), b->t);
      EXPECT_EQ(a->primitive, b->primitive);
      EXPECT_EQ(a->barycentric, b->barycentric);
      const Surface x = plain.surface(ray, *a), y = scaled.surface(far, *b);
      EXPECT_EQ(x.p * static_cast<float>(factor), y.p);
      EXPECT_EQ(x.ng, y.ng);
      EXPECT_EQ(x.error * static_cast<float>(factor), y.error);
      EXPECT_EQ(x.at.uv, y.at.uv);
    }
    EXPECT_GT(hits, 2000);
  }
}

}  // namespace
}  // namespace umbral
