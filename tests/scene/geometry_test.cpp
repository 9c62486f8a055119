// From hits to surfaces: points within their error of the true surface, normals on the outer side, uv, ids.
#include "scene/geometry.h"

#include <functional>

#include <gtest/gtest.h>

#include "worlds.h"

namespace umbral {
namespace {

using namespace test;

// What is true of a shape in its canonical space, by the formula of its own header.
struct TrueShape {
  const char* name;
  ShapeKinds kind;
  Affine placement;                                          // canonical to the shape's space
  std::function<SurfacePoint(const Vec3d&)> nearest;         // to a canonical point near the surface
  std::function<SurfacePoint(const glm::dvec2&)> somewhere;  // on the surface
};

SurfacePoint flat_point(const Vec3d& p, const Vec3d& n) { return {p, n, {0, 0}, {}, {}}; }

// The face of the unit cube [−1, 1]³ that the point is nearest to, and the point's foot on it.
SurfacePoint nearest_of_cube(const Vec3d& p) {
  int axis = 0;
  for (int i = 1; i < 3; ++i)
    if (std::abs(p[i]) > std::abs(p[axis])) axis = i;
  Vec3d foot = p, n(0);
  foot[axis] = n[axis] = std::copysign(1.0, p[axis]);
  return flat_point(foot, n);
}

template <class Analytic>
TrueShape analytic(const char* name, const Analytic& shape) {
  return {name, shape, shape.placement(), [=](const Vec3d& p) { return shape.nearest(p); },
          [=](const glm::dvec2& uv) { return shape.at(uv); }};
}

std::vector<TrueShape> true_shapes() {
  const auto on_plane = [](const Vec3d& p) { return flat_point({p.x, p.y, 0}, {0, 0, 1}); };
  const auto on_square = [](const glm::dvec2& uv) {
    return flat_point({2 * uv.x - 1, 2 * uv.y - 1, 0}, {0, 0, 1});
  };
  const auto on_cube = [](const glm::dvec2& uv) {
    const auto face = static_cast<int>(6 * uv.x);
    Vec3d p(6 * uv.x - face, uv.y, 0.5);
    p = 2.0 * p - 1.0;
    p.z = face % 2 == 0 ? -1 : 1;
    return nearest_of_cube(face < 2 ? p : face < 4 ? Vec3d(p.z, p.x, p.y) : Vec3d(p.y, p.z, p.x));
  };
  return {analytic("sphere", sphere({0.25f, -0.5f, 1}, 0.75f)),
          analytic("disk", disk({0.5f, 1, -0.25f}, {1, 2, -3}, 1.5f)),
          analytic("torus", torus(1.5f, 0.5f)),
          analytic("spindle", torus(0.5f, 0.75f)),
          {"rectangle", rectangle({-1, -1, 0}, {2, 0, 0}, {0, 2, 0}), {}, on_plane, on_square},
          {"box", box({-1, -1, -1}, {1, 1, 1}), {}, nearest_of_cube, on_cube}};
}

class Surfaces : public testing::TestWithParam<bool> {};
INSTANTIATE_TEST_SUITE_P(Of, Surfaces, testing::Bool(),
                         [](const auto& way) { return way.param ? "Instances" : "TheWorld"; });

// Rays from anywhere to points known to be on the shape, which is turned, squeezed and mirrored in space.
TEST_P(Surfaces, LieWithinTheirErrorOfTheTruthAndFaceOutwards) {
  Random random(1);
  for (const TrueShape& truth : true_shapes())
    for (int i = 0; i < 60; ++i) {
      SCOPED_TRACE(truth.name);
      const double scale = random.log_between(1e-3, 1e3);
      const Affine place = random_affine(random, scale, 8 * scale, scale * random.log_between(0.1, 100));
      const Affine to_world = place * truth.placement, from_world = inverse(to_world);
      const Scene scene(world_of(truth.kind, place, GetParam()));
      int hits = 0;
      for (int k = 0; k < 60; ++k) {
        const double u = random.between(0, 1), v = random.between(0, 1);
        const Vec3d target = to_world.point(truth.somewhere({u, v}).p);
        const Vec3 origin(target + random.in_cube(10 * scale));
        const Ray ray{origin, glm::normalize(Vec3(target) - origin)};
        const auto surface = seen(scene, ray);
        if (!surface) continue;
        ++hits;
        const SurfacePoint foot = truth.nearest(from_world.point(Vec3d(surface->p)));
        const Vec3d n = glm::normalize(from_world.transposed(foot.n));
        const double distance = dot(Vec3d(surface->p) - to_world.point(foot.p), n);
        EXPECT_LE(std::abs(distance), surface->error);
        // A place that is off by its error turns the normal by that over the radius of curvature: r σ²min/σmax, with
        // tubes of r ≥ 1/4 and stretches σ from scale to 8 scale.
        EXPECT_NEAR(glm::length(Vec3d(surface->ng) - n), 0, 2e-5 + 32 * surface->error / scale);
        EXPECT_GT(dot(Vec3d(surface->ng), to_world.vector(foot.n)), 0) << "outwards, mirrored or not";
        EXPECT_EQ(surface->shading.n, surface->ng);
        EXPECT_EQ(surface->material, static_cast<MaterialId>(0));
        EXPECT_EQ(surface->light, LightId::none);
      }
      EXPECT_GT(hits, 40);
    }
}

TEST_P(Surfaces, HaveAnErrorNoLargerThanTheirNumbersAskFor) {
  Random random(2);
  for (const TrueShape& truth : true_shapes()) {
    const Affine place = random_affine(random, 1, 4, 10);
    const Scene scene(world_of(truth.kind, place, GetParam()));
    for (int k = 0; k < 200; ++k) {
      const Vec3 origin(random.in_cube(40));
      const auto surface = seen(scene, {origin, Vec3(random.direction())});
      EXPECT_LT(surface ? surface->error : 0, 32 * 1.2e-7 * 60) << truth.name;
    }
  }
}

// The parametrisation of analytic shapes moves with them; so does that of a mesh, mirrored or not.
TEST_P(Surfaces, KeepTheirUv) {
  Random random(3);
  for (int i = 0; i < 50; ++i) {
    const Affine place = random_affine(random, 0.5, 2, 3);
    const Torus ring = torus(1, 0.25f);
    Mesh mesh = polygon({{-1, -1, 0}, {2, -1, 0}, {0, 2, 1}});
    mesh.uvs = {{0.1f, 0.2f}, {0.9f, 0.3f}, {0.4f, 0.8f}};
    const Scene ring_scene(world_of(ring, place, GetParam())), mesh_scene(world_of(mesh, place, GetParam()));
    for (int k = 0; k < 50; ++k) {
      const glm::dvec2 uv(random.between(0.01, 0.99), random.between(0.01, 0.99));
      const SurfacePoint p = ring.at(uv);
      // From just outside, straight down onto the point.
      const Vec3d q = place.point(p.p), above = place.point(p.p + 1e-3 * p.n);
      const auto on_ring = seen(ring_scene, {Vec3(above), Vec3(q - above)});
      ASSERT_TRUE(on_ring);
      EXPECT_NEAR(on_ring->at.uv.x, uv.x, 1e-3);
      EXPECT_NEAR(on_ring->at.uv.y, uv.y, 1e-3);

      const double b = random.between(0.01, 0.98), c = random.between(0.01, 0.99 - b), a = 1 - b - c;
      const Vec3d on = a * Vec3d(-1, -1, 0) + b * Vec3d(2, -1, 0) + c * Vec3d(0, 2, 1);
      const Vec3d r = place.point(on), from = place.point(on + Vec3d(0, 0, 1));
      const auto on_mesh = seen(mesh_scene, {Vec3(from), Vec3(r - from)});
      ASSERT_TRUE(on_mesh);
      EXPECT_NEAR(on_mesh->at.uv.x, a * 0.1 + b * 0.9 + c * 0.4, 1e-5);
      EXPECT_NEAR(on_mesh->at.uv.y, a * 0.2 + b * 0.3 + c * 0.8, 1e-5);
    }
  }
}

// Interpolated normals stay on the side of the true normal, and face whoever sees that side.
TEST_P(Surfaces, HaveShadingNormalsThatFaceTheViewer) {
  Random random(4);
  for (int i = 0; i < 20; ++i) {
    const Affine place = random_affine(random, 0.5, 3, 3), back = inverse(place);
    const Scene scene(world_of(icosphere(1, true), place, GetParam()));
    double largest = 0;
    for (int k = 0; k < 500; ++k) {
      const Vec3 origin(place.point(k % 4 == 0 ? random.in_cube(0.4) : 3.0 * random.direction()));
      const Vec3 target(place.point(random.in_cube(0.7)));
      const Ray ray{origin, glm::normalize(target - origin)};
      const auto surface = seen(scene, ray);
      if (!surface) continue;
      const Vec3 wo = -ray.d, &ns = surface->shading.n, &ng = surface->ng;
      EXPECT_GT(dot(wo, ns) * dot(wo, ng), 0);
      EXPECT_GT(dot(ng, Vec3(place.vector(back.point(Vec3d(surface->p))))), 0) << "ng outwards";
      for (const Vec3& axis : {surface->shading.s, surface->shading.t, ns})
        EXPECT_NEAR(glm::length(axis), 1, 2e-6);
      EXPECT_NEAR(dot(surface->shading.s, surface->shading.t), 0, 2e-6);
      EXPECT_NEAR(dot(surface->shading.s, ns), 0, 2e-6);
      // Where the true smooth normal faces the viewer as the flat one does, it is not touched.
      const Vec3d smooth = glm::normalize(back.transposed(glm::normalize(back.point(Vec3d(surface->p)))));
      const bool agrees = dot(smooth, Vec3d(wo)) * dot(wo, ng) > 0.05;
      // (In the world the normals are carried over before they are interpolated, which a squeeze does not commute
      // with.)
      if (agrees && GetParam()) {
        EXPECT_LT(glm::length(smooth - Vec3d(ns)), 0.06);
      }
      largest = std::max(largest, glm::length(smooth - Vec3d(ng)));
    }
    EXPECT_GT(largest, 0.1) << "the sphere is too smooth to tell the normals apart";
  }
}

TEST(Surfaces, OfAMeshWithoutUvHaveBarycentricOnes) {
  const Scene scene(world_of(polygon({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}), {}, false));
  const auto surface = seen(scene, {{0.25f, 0.5f, 1}, {0, 0, -1}});
  ASSERT_TRUE(surface);
  EXPECT_NEAR(surface->at.uv.x, 0.25, 1e-6);
  EXPECT_NEAR(surface->at.uv.y, 0.5, 1e-6);
}

// Each face of a box has its own unit square of uv, seen upright and not mirrored from outside.
TEST(Surfaces, OfABoxHaveAUnitSquareOfUvOnEachFace) {
  const Scene scene(world_of(box({0, 0, 0}, {1, 2, 3}), {}, false));
  for (int axis = 0; axis < 3; ++axis)
    for (const double side : {-1.0, 1.0}) {
      const auto uv_at = [&](double a, double b) {
        Vec3d relative(0);
        relative[axis] = side > 0 ? 2 : -1;
        relative[(axis + 1) % 3] = a;
        relative[(axis + 2) % 3] = b;
        Vec3 d(0);
        d[axis] = static_cast<float>(-side);
        return seen(scene, {Vec3(relative * Vec3d(1, 2, 3)), d})->at.uv;
      };
      const Vec2 o = uv_at(0.1, 0.2), a = uv_at(0.9, 0.2), b = uv_at(0.1, 0.8);
      const Vec2 along_a = (a - o) / 0.8f, along_b = (b - o) / 0.6f;
      const double turn = along_a.x * along_b.y - along_a.y * along_b.x;
      EXPECT_NEAR(turn, side, 1e-4) << "axis " << axis
                                    << ": area 1, and its turn is that of the face from outside";
    }
}

TEST(Surfaces, KnowWhichLightTheyAre) {
  SceneDescription scene;
  const MaterialId matte = add_matte(scene, grey(0.5f));
  add_shape(scene, sphere({0, 0, 0}, 0.5f), matte);
  add_shape(scene, sphere({2, 0, 0}, 0.5f), matte, white);
  Shape dark, bright;
  dark.kind = disk({0, 0, 0}, {0, 0, 1}, 0.2f);
  bright.kind = disk({0.5f, 0, 0}, {0, 0, 1}, 0.2f);
  dark.material = bright.material = matte;
  bright.emission.value = white;
  scene.objects.push_back({"", {dark, bright, bright}});
  std::get<Disk>(scene.objects[0].shapes[2].kind).center.x = 1;
  for (const double y : {10.0, 20.0})
    scene.instances.push_back({static_cast<ObjectId>(0), translation({0, y, 0})});
  scene.lights.emplace_back(PointLight{});
  const Scene world(std::move(scene));
  ASSERT_EQ(world.light_count(), 6u);
  const auto light_at = [&](float x, float y) { return seen(world, {{x, y, 5}, {0, 0, -1}})->light; };
  EXPECT_EQ(light_at(0, 0), LightId::none);
  EXPECT_EQ(light_at(2, 0), static_cast<LightId>(0));
  EXPECT_EQ(light_at(0, 10), LightId::none);
  EXPECT_EQ(light_at(0.5f, 10), static_cast<LightId>(1));
  EXPECT_EQ(light_at(1, 10), static_cast<LightId>(2));
  EXPECT_EQ(light_at(0.5f, 20), static_cast<LightId>(3));
  EXPECT_EQ(light_at(1, 20), static_cast<LightId>(4));
}

}  // namespace
}  // namespace umbral
