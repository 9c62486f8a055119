// Rays that leave a surface must not meet it again where they start, however large, far or thin it is, and must not
// jump over what lies close to it.
#include <gtest/gtest.h>

#include "worlds.h"

namespace umbral {
namespace {

using namespace test;

constexpr int instances = 300, rays_each = 300;

// Between 1e-4 and 1e4, of either sign.
double anywhere(Random& random) {
  const double size = std::pow(10, random.between(-4, 4));
  return random.coin() ? size : -size;
}

Vec3d far_or_near(Random& random) {
  const double x = anywhere(random), y = anywhere(random), z = anywhere(random);
  return {x, y, z};
}

// Whether a ray that left `surface` came back to where it started. No ray that leaves a triangle can meet that one
// again; of a curved shape, legitimate hits are at least `chord` × cos away, cos being that of the ray to the normal:
// chord = 2/κ for a surface of curvature ≤ κ, infinite where rays leave a convex shape outwards.
bool is_self_hit(const Hit& left, const Surface& surface, const Vec3& d, const std::optional<Hit>& again,
                 double chord) {
  if (!again || again->geometry != left.geometry || again->instance != left.instance) return false;
  if (chord == 0) return again->primitive == left.primitive;
  return again->t < 0.5 * chord * std::abs(dot(Vec3d(d), Vec3d(surface.ng)));
}

struct Trial {
  ShapeKinds kind;
  Affine to_world;
  Vec3d target;  // a world point on the shape; random ones lie about it
  double size;   // world
  double chord;  // as above, world; 0 for triangles
};

template <class Make>
void expect_no_self_hits(const Make& make, bool instanced, bool outwards_only, std::uint64_t seed) {
  Random random(seed);
  long spawned = 0, self_hits = 0;
  for (int i = 0; i < instances; ++i) {
    const Trial trial = make(random);
    const Scene scene(world_of(trial.kind, trial.to_world, instanced));
    for (int k = 0; k < rays_each; ++k) {
      const Vec3d from = trial.target + 2 * trial.size * random.direction();
      const Vec3d to = trial.target + 0.3 * trial.size * random.direction();
      const Ray ray{Vec3(from), Vec3(glm::normalize(to - from))};
      const auto hit = scene.intersect(ray);
      if (!hit) continue;
      const Surface surface = scene.surface(ray, *hit);
      // Curved shapes that are no larger than the digits of their place are no longer round.
      if (trial.chord > 0 && surface.error > 0.01 * trial.size) continue;
      Vec3 d(random.direction());
      if (outwards_only && dot(d, surface.ng) < 0) d = -d;
      const auto again = scene.intersect(surface.ray_towards(d));
      ++spawned;
      self_hits += is_self_hit(*hit, surface, d, again, trial.chord);
    }
  }
  EXPECT_EQ(self_hits, 0) << "of " << spawned;
  EXPECT_GT(spawned, instances * rays_each / 10);
}

double any_size(Random& random) { return std::pow(10, random.between(-4, 4)); }

Trial sphere_trial(Random& random) {
  const double radius = any_size(random);
  const Vec3d center = far_or_near(random);
  const Vec3d target = center + radius * random.direction();
  return {sphere(Vec3(center), static_cast<float>(radius)), {}, target, radius, 2 * radius};
}

Trial torus_trial(Random& random, double ratio) {
  const double major = any_size(random), minor = ratio * major;
  const Affine place = translation(far_or_near(random)) * random_rotation(random);
  const double phi = random.between(0, 2 * pi_d), psi = random.between(0, 2 * pi_d),
               rho = major + minor * std::cos(psi);
  const Vec3d target = place.point({rho * std::cos(phi), rho * std::sin(phi), minor * std::sin(psi)});
  const double chord = 2 * std::min(minor, std::abs(major - minor));
  return {torus(static_cast<float>(major), static_cast<float>(minor)), place, target, minor, chord};
}

Trial disk_trial(Random& random) {
  const double radius = any_size(random);
  const Vec3d center = far_or_near(random), normal = random.direction();
  return {disk(Vec3(center), Vec3(normal), static_cast<float>(radius)), {}, center, radius, infinity};
}

Trial rectangle_trial(Random& random) {
  const Vec3d middle = far_or_near(random);
  const Vec3d u = any_size(random) * random.direction(), v = any_size(random) * random.direction();
  const double size = std::min(glm::length(u), glm::length(v));
  return {rectangle(Vec3(middle - u / 2.0 - v / 2.0), Vec3(u), Vec3(v)), {}, middle, size, 0};
}

Trial triangle_trial(Random& random, double thinness) {
  const double size = any_size(random);
  const Vec3d middle = far_or_near(random), along = size * random.direction(),
              across = size * thinness * random.direction();
  const Vec3d a = middle - along / 2.0, b = middle + along / 2.0, c = middle + across;
  return {polygon({Vec3(a), Vec3(b), Vec3(c)}),
          {},
          (Vec3d(Vec3(a)) + Vec3d(Vec3(b)) + Vec3d(Vec3(c))) / 3.0,
          size * thinness,
          0};
}

Trial box_trial(Random& random) {
  const Vec3d half(any_size(random), any_size(random), any_size(random)), middle = far_or_near(random);
  const double size = std::min({half.x, half.y, half.z});
  return {box(Vec3(middle - half), Vec3(middle + half)), {}, middle + Vec3d(0, 0, half.z), size, 0};
}

// An object about the origin, put in its place by an instance that turns and stretches it.
template <class Kind>
Trial instanced_trial(Random& random, const Kind& kind, const Vec3d& on_it) {
  constexpr bool triangles = !ParametricShape<Kind>;
  const Affine place =
      translation(far_or_near(random)) * random_affine(random, 0.3, 3, 0) * scaling(Vec3d(any_size(random)));
  const double size = std::cbrt(std::abs(place.determinant()));
  return {kind, place, place.point(on_it), size, triangles ? 0 : infinity};
}

TEST(SelfHits, OfSpheresAreNone) { expect_no_self_hits(sphere_trial, false, false, 1); }
TEST(SelfHits, OfDisksAreNone) { expect_no_self_hits(disk_trial, false, false, 2); }
TEST(SelfHits, OfRectanglesAreNone) { expect_no_self_hits(rectangle_trial, false, false, 3); }
TEST(SelfHits, OfBoxesAreNone) { expect_no_self_hits(box_trial, false, false, 4); }

TEST(SelfHits, OfToriAreNone) {
  std::uint64_t seed = 5;
  for (const double ratio : {0.25, 0.01, 0.9}) {
    SCOPED_TRACE(ratio);
    expect_no_self_hits([=](Random& random) { return torus_trial(random, ratio); }, false, false, seed++);
  }
}

TEST(SelfHits, OfTrianglesAreNone) {
  std::uint64_t seed = 10;
  for (const double thinness : {1.0}) {
    SCOPED_TRACE(thinness);
    expect_no_self_hits([=](Random& random) { return triangle_trial(random, thinness); }, false, false,
                        seed++);
  }
}

TEST(SelfHits, OfInstancesAreNone) {
  const auto trial = [](const auto& kind, const Vec3d& on_it) {
    return [=](Random& random) { return instanced_trial(random, kind, on_it); };
  };
  expect_no_self_hits(trial(sphere({0, 0, 0}, 1), {1, 0, 0}), true, true, 20);
  expect_no_self_hits(trial(disk({0, 0, 0}, {0, 0, 1}, 1), {0, 0, 0}), true, true, 21);
  expect_no_self_hits(trial(rectangle({-1, -1, 0}, {2, 0, 0}, {0, 2, 0}), {0, 0, 0}), true, true, 22);
  expect_no_self_hits(trial(box({-1, -1, -1}, {1, 1, 1}), {0, 1, 0}), true, true, 23);
  expect_no_self_hits(trial(icosphere(3), {0, 0, 1}), true, true, 24);
}

// Objects that were moved twice, once within themselves and back by their instance, are near the origin but made
// from large numbers.
TEST(SelfHits, OfObjectsThatWereMovedBackAreNone) {
  const auto moved = [](const auto& kind, const Vec3d& on_it) {
    return [=](Random& random) {
      const Vec3d away = random.in_cube(100);
      Trial trial{kind,
                  random_rotation(random) * translation(-away),
                  {},
                  1,
                  ParametricShape<std::remove_cvref_t<decltype(kind)>> ? double{infinity} : 0};
      trial.target = trial.to_world.point(on_it + away);
      std::visit(
          [&](auto& k) {
            if constexpr (requires { k.center; }) k.center = Vec3(away);
            if constexpr (requires { k.origin; }) k.origin += Vec3(away);
          },
          trial.kind);
      return trial;
    };
  };
  for (const bool instanced : {false, true}) {
    expect_no_self_hits(moved(sphere({0, 0, 0}, 1), {1, 0, 0}), instanced, true, 30);
    expect_no_self_hits(moved(disk({0, 0, 0}, {0, 1, 0}, 1), {0, 0, 0}), instanced, false, 31);
    expect_no_self_hits(moved(rectangle({-1, -1, 0}, {2, 0, 0}, {0, 2, 0}), {0, 0, 0}), instanced, false, 32);
  }
}

// A shell close around a sphere is met by every ray that leaves the sphere, and the sphere by every ray that enters
// the shell towards it. The gap is a few times what the float numbers can tell apart there.
TEST(Neighbours, AreNotJumpedOver) {
  for (const auto& [distance, gap] : {std::pair{0.0, 4e-5}, {0.0, 1e-3}, {100.0, 2e-3}, {1e4, 0.2}}) {
    SCOPED_TRACE(distance);
    Random random(40);
    const Vec3 center(distance * random.direction());
    SceneDescription description;
    const MaterialId matte = add_matte(description, grey(0.5f));
    add_shape(description, sphere(center, 1), matte);
    add_shape(description, sphere(center, static_cast<float>(1 + gap)), matte);
    const Scene scene(std::move(description));
    int missed = 0;
    for (int i = 0; i < 100'000; ++i) {
      const Vec3 toward(random.direction());
      const Ray ray{center, toward};
      const auto hit = scene.intersect(ray);
      ASSERT_TRUE(hit);
      ASSERT_EQ(hit->geometry, 0u);
      const Surface inner = scene.surface(ray, *hit);
      Vec3 d(random.direction());
      if (dot(d, inner.ng) < 0) d = -d;
      const Ray outwards = inner.ray_towards(d);
      const auto shell = scene.intersect(outwards);
      missed += !shell || shell->geometry != 1;
      if (!shell) continue;
      const auto back = scene.intersect(scene.surface(outwards, *shell).ray_towards(-inner.ng));
      missed += !back || back->geometry != 0;
    }
    EXPECT_EQ(missed, 0);
  }
}

TEST(Neighbours, InTheCornersOfABoxAreMet) {
  for (const double distance : {0.0}) {
    SCOPED_TRACE(distance);
    Random random(41);
    const Vec3d middle = distance * random.direction();
    const Scene scene(world_of(box(Vec3(middle - 1.0), Vec3(middle + 1.0)), {}, false));
    int escaped = 0;
    Ray ray{Vec3(middle), Vec3(random.direction())};
    for (int i = 0; i < 300'000; ++i) {
      const auto hit = scene.intersect(ray);
      if (!hit) {
        ++escaped;
        ray = {Vec3(middle), Vec3(random.direction())};
        continue;
      }
      const Surface surface = scene.surface(ray, *hit);
      // Every other ray runs along the face into a corner.
      Vec3 d(random.direction());
      if (i % 2 == 0) d = glm::normalize(d - surface.ng * dot(d, surface.ng) - surface.ng * 1e-3f);
      if (dot(d, surface.ng) > 0) d = -d;
      ray = surface.ray_towards(d);
    }
    EXPECT_EQ(escaped, 0);
  }
}

}  // namespace
}  // namespace umbral
