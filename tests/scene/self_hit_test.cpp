// Rays that leave a surface must not meet it again where they start, however large, far or thin it is, and must not
// jump over what lies close to it.
#include <functional>

#include <gtest/gtest.h>

#include "support/stability.h"
#include "worlds.h"

namespace umbral {
namespace {

using namespace test;

constexpr int instances = 1000, rays_each = 1000;

// Between 1e-8 and 1e8, of either sign.
double anywhere(Random& random) {
  const double size = std::pow(10, random.between(-8, 8));
  return random.coin() ? size : -size;
}

Vec3d far_or_near(Random& random) {
  const double x = anywhere(random), y = anywhere(random), z = anywhere(random);
  return {x, y, z};
}

// How far a ray really goes that leaves the true shape at its point nearest to p, before it meets it again.
using NextCrossing = std::function<double(const Vec3& p, const Vec3& d)>;

struct Trial {
  ShapeKinds kind;
  Affine to_world;
  Vec3d target;                 // a world point on the shape; random ones lie about it
  double size;                  // world
  NextCrossing next = nullptr;  // of analytic shapes
  bool flat = false;            // whatever of it is met again is where the ray started
};

template <class Analytic>
Trial analytic_trial(const Analytic& shape, const Affine& place, const Vec3d& target, double size) {
  const Affine to_world = place * shape.placement(), from_world = inverse(to_world);
  return {shape, place, target, size, [=](const Vec3& p, const Vec3& d) {
            const Vec3d start = shape.nearest(from_world.point(Vec3d(p))).p,
                        along = from_world.vector(Vec3d(d));
            return shape.intersect(start, along, 1e-9 / glm::length(along), 1e30).value_or(infinity);
          }};
}

// Whether a ray that left `surface` came back to where it started. No ray that leaves a triangle meets that one again.
bool is_self_hit(const Trial& trial, const Hit& left, const Surface& surface, const Vec3& d,
                 const std::optional<Hit>& again) {
  if (!again || again->geometry != left.geometry || again->instance != left.instance) return false;
  if (!trial.next) return trial.flat || again->primitive == left.primitive;
  return again->t < std::min(0.5 * trial.next(surface.p, d), 0.01 * trial.size);
}

// `make` gives a Trial.
template <class Make>
void expect_no_self_hits(const std::string& of, const Make& make, bool instanced, std::uint64_t seed) {
  Random random(seed);
  long spawned = 0, self_hits = 0;
  for (int i = 0; i < instances; ++i) {
    const Trial trial = make(random);
    const Scene scene(world_of(trial.kind, trial.to_world, instanced));
    for (int k = 0; k < rays_each; ++k) {
      const Vec3d from = trial.target + 2 * trial.size * random.direction();
      const Vec3d to = trial.target + 0.3 * trial.size * random.direction();
      if (from == to) continue;  // too far away even for double
      const Ray ray{Vec3(from), Vec3(glm::normalize(to - from))};
      const auto hit = scene.intersect(ray);
      if (!hit) continue;
      const Surface surface = scene.surface(ray, *hit);
      const Vec3 d(random.direction());
      // Round shapes no larger than the digits of their place are no longer round, and a chord within the error of
      // its start is none.
      if (trial.next && (surface.error > 0.01 * trial.size || trial.next(surface.p, d) < 100 * surface.error))
        continue;
      ++spawned;
      self_hits += is_self_hit(trial, *hit, surface, d, scene.intersect(surface.ray_towards(d)));
    }
  }
  EXPECT_EQ(self_hits, 0) << "of " << spawned;
  EXPECT_GT(spawned, instances * rays_each / 10);
  record({"Rays that start on a surface", "self-hits of " + of, "0",
          fmt::format("{} of {}", self_hits, spawned), "mitsuba3 #219, #61, PR #1962"});
}

double any_size(Random& random) { return std::pow(10, random.between(-8, 8)); }

Trial sphere_trial(Random& random) {
  const double radius = any_size(random);
  const Vec3d center = far_or_near(random);
  const Vec3d target = center + radius * random.direction();
  return analytic_trial(sphere(Vec3(center), static_cast<float>(radius)), {}, target, radius);
}

Trial torus_trial(Random& random, double ratio) {
  const double major = any_size(random), minor = ratio * major;
  const Affine place = translation(far_or_near(random)) * random_rotation(random);
  const double phi = random.between(0, 2 * pi_d), psi = random.between(0, 2 * pi_d);
  const double rho = major + minor * std::cos(psi);
  const Vec3d target = place.point({rho * std::cos(phi), rho * std::sin(phi), minor * std::sin(psi)});
  return analytic_trial(torus(static_cast<float>(major), static_cast<float>(minor)), place, target, minor);
}

Trial disk_trial(Random& random) {
  const double radius = any_size(random);
  const Vec3d center = far_or_near(random), normal = random.direction();
  return analytic_trial(disk(Vec3(center), Vec3(normal), static_cast<float>(radius)), {}, center, radius);
}

Trial rectangle_trial(Random& random) {
  const Vec3d middle = far_or_near(random);
  const Vec3d u = any_size(random) * random.direction(), v = any_size(random) * random.direction();
  const double size = std::min(glm::length(u), glm::length(v));
  return {rectangle(Vec3(middle - u / 2.0 - v / 2.0), Vec3(u), Vec3(v)), {}, middle, size};
}

Trial triangle_trial(Random& random, double thinness) {
  const double size = any_size(random);
  const Vec3d middle = far_or_near(random), along = size * random.direction();
  const Vec3d across = size * thinness * random.direction();
  const Vec3 a(middle - along / 2.0), b(middle + along / 2.0), c(middle + across);
  return {polygon({a, b, c}), {}, (Vec3d(a) + Vec3d(b) + Vec3d(c)) / 3.0, size * thinness};
}

// Twice the same triangle, from corners of its own.
Trial doubled_triangle_trial(Random& random, double thinness) {
  Trial trial = triangle_trial(random, thinness);
  auto& mesh = std::get<Mesh>(trial.kind);
  for (const std::size_t corner : {1u, 2u, 0u}) mesh.positions.push_back(mesh.positions[corner]);
  mesh.triangles.push_back({3, 4, 5});
  trial.flat = true;
  return trial;
}

Trial box_trial(Random& random) {
  const Vec3d half(any_size(random), any_size(random), any_size(random)), middle = far_or_near(random);
  const double size = std::min({half.x, half.y, half.z});
  return {box(Vec3(middle - half), Vec3(middle + half)), {}, middle + Vec3d(0, 0, half.z), size};
}

// A shape of this size about the origin, put in its place by an instance that turns and stretches it.
template <class Kind>
Trial instanced_trial(Random& random, const Kind& kind, const Vec3d& on_it, double own_size) {
  const Affine stretch = random_affine(random, 0.3, 3, 0);
  const Affine place = translation(far_or_near(random)) * stretch * scaling(Vec3d(any_size(random)));
  const double size = own_size * std::cbrt(std::abs(place.determinant()));
  if constexpr (ParametricShape<Kind>)
    return analytic_trial(kind, place, place.point(on_it), size);
  else
    return {kind, place, place.point(on_it), size};
}

// A shape that was moved away within itself and back by its place: near the origin, but made from large numbers.
template <class Kind>
Trial returned_trial(Random& random, Kind kind, const Vec3d& on_it) {
  const Vec3 away(random.in_cube(100));
  if constexpr (requires { kind.center; })
    kind.center = away;
  else
    kind.origin += away;
  const Affine place = random_rotation(random) * translation(-Vec3d(away));
  const Vec3d target = place.point(on_it + Vec3d(away));
  if constexpr (ParametricShape<Kind>)
    return analytic_trial(kind, place, target, 1);
  else
    return {kind, place, target, 1};
}

TEST(SelfHits, OfSpheresAreNone) { expect_no_self_hits("spheres", sphere_trial, false, 1); }
TEST(SelfHits, OfDisksAreNone) { expect_no_self_hits("disks", disk_trial, false, 2); }
TEST(SelfHits, OfRectanglesAreNone) { expect_no_self_hits("rectangles", rectangle_trial, false, 3); }
TEST(SelfHits, OfBoxesAreNone) { expect_no_self_hits("boxes", box_trial, false, 4); }

TEST(SelfHits, OfToriAreNone) {
  std::uint64_t seed = 5;
  for (const double ratio : {0.25, 0.01, 0.9, 1.0, 1.5, 4.0}) {
    SCOPED_TRACE(ratio);
    expect_no_self_hits(
        fmt::format("tori, r = {} R", ratio), [=](Random& random) { return torus_trial(random, ratio); },
        false, seed++);
  }
}

TEST(SelfHits, OfTrianglesAreNone) {
  std::uint64_t seed = 50;
  for (const double thinness : {1.0, 1e-1, 1e-2, 1e-3, 1e-4, 1e-6}) {
    SCOPED_TRACE(thinness);
    expect_no_self_hits(
        fmt::format("triangles, {:g} as thin as long", thinness),
        [=](Random& random) { return triangle_trial(random, thinness); }, false, seed++);
  }
}

TEST(SelfHits, OfDoubledTrianglesAreNone) {
  std::uint64_t seed = 60;
  for (const double thinness : {1.0, 1e-3, 1e-6}) {
    SCOPED_TRACE(thinness);
    expect_no_self_hits(
        fmt::format("triangles that lie there twice, {:g} as thin as long", thinness),
        [=](Random& random) { return doubled_triangle_trial(random, thinness); }, false, seed++);
  }
}

TEST(SelfHits, OfInstancesAreNone) {
  const auto trial = [](const auto& kind, const Vec3d& on_it, double size = 1) {
    return [=](Random& random) { return instanced_trial(random, kind, on_it, size); };
  };
  expect_no_self_hits("instanced spheres", trial(sphere({0, 0, 0}, 1), {1, 0, 0}), true, 20);
  expect_no_self_hits("instanced disks", trial(disk({0, 0, 0}, {0, 0, 1}, 1), {0, 0, 0}), true, 21);
  expect_no_self_hits("instanced tori", trial(torus(1, 0.5f), {1, 0, 0.5}), true, 22);
  expect_no_self_hits("instanced rectangles", trial(rectangle({-1, -1, 0}, {2, 0, 0}, {0, 2, 0}), {0, 0, 0}),
                      true, 23);
  expect_no_self_hits("instanced boxes", trial(box({-1, -1, -1}, {1, 1, 1}), {0, 1, 0}), true, 24);
  expect_no_self_hits("instanced meshes", trial(icosphere(3), {0, 0, 1}), true, 25);
  const Mesh sliver = polygon({{-1, 0, 0.5f}, {0.8f, 0.3f, -0.6f}, {-0.1f, 0.151f, -0.051f}});
  expect_no_self_hits("instanced slivers", trial(sliver, {-0.1, 0.150333, -0.050333}, 5e-4), true, 26);
}

TEST(SelfHits, OfShapesThatWereMovedBackAreNone) {
  const auto trial = [](const auto& kind, const Vec3d& on_it) {
    return [=](Random& random) { return returned_trial(random, kind, on_it); };
  };
  for (const bool instanced : {false, true}) {
    expect_no_self_hits(fmt::format("spheres moved away and back{}", instanced ? ", instanced" : ""),
                        trial(sphere({0, 0, 0}, 1), {1, 0, 0}), instanced, 30);
    expect_no_self_hits(fmt::format("disks moved away and back{}", instanced ? ", instanced" : ""),
                        trial(disk({0, 0, 0}, {0, 1, 0}, 1), {0, 0, 0}), instanced, 31);
    expect_no_self_hits(fmt::format("rectangles moved away and back{}", instanced ? ", instanced" : ""),
                        trial(rectangle({-1, -1, 0}, {2, 0, 0}, {0, 2, 0}), {0, 0, 0}), instanced, 32);
  }
}

// A shell close around a sphere is met by every ray that leaves the sphere, and the sphere by every ray that enters
// the shell towards it. The gap is a few times what the float numbers can tell apart there.
TEST(Neighbours, AreNotJumpedOver) {
  for (const auto& [distance, gap] : {std::pair{0.0, 1e-5}, {0.0, 1e-3}, {100.0, 2e-3}, {1e4, 0.2}}) {
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
    record({"Rays that start on a surface",
            fmt::format("a shell {:g} over a unit sphere {:g} away is jumped over", gap, distance), "0",
            fmt::format("{} of 200000", missed), "mitsuba3 PR #1871, mitsuba2 #171"});
  }
}

TEST(Neighbours, InTheCornersOfABoxAreMet) {
  Random random(41);
  for (const Affine& place : {Affine{}, random_rotation(random)}) {
    const Scene scene(world_of(box({-1, -1, -1}, {1, 1, 1}), place, false));
    int escaped = 0;
    Ray ray{{0, 0, 0}, Vec3(random.direction())};
    for (int i = 0; i < 300'000; ++i) {
      const auto hit = scene.intersect(ray);
      if (!hit) {
        ++escaped;
        ray = {{0, 0, 0}, Vec3(random.direction())};
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
    record({"Rays that start on a surface",
            place.is_identity() ? "rays escape from the corners of a box" : "the same, of a turned box", "0",
            fmt::format("{} of 300000", escaped)});
  }
}

}  // namespace
}  // namespace umbral
