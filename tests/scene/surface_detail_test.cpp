// Surface detail: frames along uv, normal and bump maps, and normals about which every lobe can reflect.
#include "scene/surface_detail.h"

#include <gtest/gtest.h>

#include "support/stability.h"
#include "worlds.h"

namespace umbral {
namespace {

using namespace test;

// A lobe that looks different when it is turned.
Conductor brushed() {
  Conductor lobe;
  lobe.anisotropy = 0.5f;
  return lobe;
}

// A map of one normal everywhere.
TextureId one_normal(SceneDescription& scene, const Vec3& n, float rotation = 0) {
  CheckerTexture map;
  map.even = map.odd = Spectrum((glm::normalize(n) + 1.0f) / 2.0f, 0);
  map.uv_rotation = rotation;
  return add_texture(scene, map);
}

void expect_near(const Vec3& a, const Vec3& b, float tolerance = 2e-5f) {
  EXPECT_LT(glm::length(a - b), tolerance)
      << a.x << " " << a.y << " " << a.z << " instead of " << b.x << " " << b.y << " " << b.z;
}

// A triangle in the plane z = 0 whose uv are an affine function of x and y.
Mesh mapped_triangle(const glm::mat2& uv_of_xy) {
  Mesh mesh = polygon({{-2, -2, 0}, {4, -2, 0}, {-2, 4, 0}});
  for (const Vec3& p : mesh.positions) mesh.uvs.push_back(uv_of_xy * Vec2(p) + Vec2(0.3f, 0.1f));
  return mesh;
}

Surface looked_at(SceneDescription description, const Vec3& target, const Vec3& from) {
  const Scene scene(std::move(description));
  const auto surface = seen(scene, {from, target - from});
  EXPECT_TRUE(surface);
  return surface.value_or(Surface{});
}

TEST(SurfaceFrame, FollowsUWhereTheLobeAsksForIt) {
  const float c = std::cos(0.7f), s = std::sin(0.7f);
  SceneDescription turned = world_of(mapped_triangle({c, s, -s, c}), {}, false);
  Principled principled;
  principled.anisotropy = 0.5f;
  Dielectric glass;
  glass.anisotropy = 0.5f;
  const Lobes base = brushed();
  for (const Lobes& lobe : {base, Lobes(principled), Lobes(glass)}) {
    turned.materials[0].lobe = lobe;
    const Surface surface = looked_at(turned, {0.1f, 0.2f, 0}, {0, 0, 3});
    expect_near(surface.shading.s, {c, -s, 0});  // along which u grows and v does not change
    expect_near(surface.shading.t, {s, c, 0});
    expect_near(surface.shading.n, {0, 0, 1});
  }
  // What a coat lies on asks for it, too.
  SceneDescription coated = turned;
  coated.materials.insert(coated.materials.begin(), Material{"metal", base, {}, {1}});
  coated.materials[1].lobe = Coat{};
  coated.materials[1].parts = {{detail::set_part<&Coat::base>, MaterialId{0}}};
  coated.shapes[0].material = MaterialId{1};
  expect_near(looked_at(coated, {0.1f, 0.2f, 0}, {0, 0, 3}).shading.s, {c, -s, 0});

  turned.materials[0].lobe = Conductor{};
  const Frame plain = frame_from_normal({0, 0, 1});
  expect_near(looked_at(turned, {0.1f, 0.2f, 0}, {0, 0, 3}).shading.s, plain.s);
}

TEST(SurfaceFrame, IsLeftHandedWhereUvIsMirrored) {
  SceneDescription scene = world_of(mapped_triangle({-1, 0, 0, 1}), {}, false);
  scene.materials[0].lobe = brushed();
  const Surface surface = looked_at(scene, {0.1f, 0.2f, 0}, {0, 0, 3});
  expect_near(surface.shading.s, {-1, 0, 0});
  expect_near(surface.shading.t, {0, 1, 0});
}

TEST(SurfaceFrame, FollowsTheParametersOfAnalyticShapesInInstancesToo) {
  for (const bool instanced : {false, true}) {
    const Affine place = translation({1, 2, 3}) * rotation(glm::normalize(Vec3d(1, 2, 3)), 1.1);
    SceneDescription scene = world_of(sphere({0, 0, 0}, 1), place, instanced);
    scene.materials[0].lobe = brushed();
    const Vec3d target = glm::normalize(Vec3d(0.5, 0.6, 0.4));
    const Surface surface = looked_at(scene, Vec3(place.point(target)), Vec3(place.point(3.0 * target)));
    expect_near(surface.shading.s, Vec3(place.vector(glm::normalize(Vec3d(-target.y, target.x, 0)))));
    EXPECT_GT(dot(surface.shading.t, Vec3(place.vector({0, 0, 1}))), 0);  // v runs to the pole
  }
}

TEST(SurfaceFrame, IsAnyWhereThereIsNoUv) {
  SceneDescription scene = world_of(polygon({{-2, -2, 0}, {4, -2, 0}, {-2, 4, 0}}), {}, false);
  scene.materials[0].lobe = brushed();
  const Surface surface = looked_at(scene, {0.1f, 0.2f, 0}, {0, 0, 3});
  expect_near(surface.shading.s, frame_from_normal({0, 0, 1}).s);
  Mesh collapsed = mapped_triangle({1, 0, 2, 0});  // v is the same everywhere
  SceneDescription flat = world_of(collapsed, {}, false);
  flat.materials[0].lobe = brushed();
  flat.materials[0].normal_map.map = one_normal(flat, {0.3f, 0, 1});
  expect_near(looked_at(flat, {0.1f, 0.2f, 0}, {0, 0, 3}).shading.n, {0, 0, 1});
}

// Lengthwise and across, by x and y of the map, whatever the uv.
TEST(NormalMap, LeansAlongUAndV) {
  const Vec3 n = glm::normalize(Vec3(0.3f, 0.2f, 1));
  struct {
    glm::mat2 uv;
    float rotation;
    Vec3 expected;
  } const cases[] = {{{1, 0, 0, 1}, 0, n},
                     {{3, 0, 0, 0.5f}, 0, n},                // stretched
                     {{-1, 0, 0, 1}, 0, {-n.x, n.y, n.z}},   // mirrored: a picture seen in a mirror
                     {{0, 1, -1, 0}, 0, {n.y, -n.x, n.z}},   // u along −y… v along x
                     {{1, 0, 0, 1}, 90, {n.y, -n.x, n.z}}};  // the picture itself is turned
  for (const auto& tested : cases) {
    SceneDescription scene = world_of(mapped_triangle(tested.uv), {}, false);
    scene.materials[0].normal_map.map = one_normal(scene, n, tested.rotation);
    expect_near(looked_at(scene, {0.1f, 0.2f, 0}, {0, 0, 3}).shading.n, tested.expected);
    // From behind it is the same surface, so the same normal.
    expect_near(looked_at(scene, {0.1f, 0.2f, 0}, {0, 0, -3}).shading.n, tested.expected);
  }
}

TEST(NormalMap, IsScaledInXAndY) {
  SceneDescription scene = world_of(mapped_triangle({1, 0, 0, 1}), {}, false);
  scene.materials[0].normal_map.map = one_normal(scene, {0.3f, 0.2f, 1});
  scene.materials[0].normal_scale = 0.5f;
  expect_near(looked_at(scene, {0.1f, 0.2f, 0}, {0, 0, 3}).shading.n, glm::normalize(Vec3(0.15f, 0.1f, 1)));
}

TEST(NormalMap, UsesTheUvSetOfItsTexture) {
  Mesh mesh = mapped_triangle({1, 0, 0, 1});
  mesh.uvs1 = mapped_triangle({0, 1, -1, 0}).uvs;
  SceneDescription scene = world_of(mesh, {}, false);
  CheckerTexture map;
  map.even = map.odd = Spectrum((glm::normalize(Vec3(0.3f, 0.2f, 1)) + 1.0f) / 2.0f, 0);
  map.uv_set = 1;
  scene.materials[0].normal_map.map = add_texture(scene, map);
  expect_near(looked_at(scene, {0.1f, 0.2f, 0}, {0, 0, 3}).shading.n, glm::normalize(Vec3(0.2f, -0.3f, 1)));
}

// A wave of height 0.05 on a parallelogram: its normal in closed form, from p(u, v) + h(u) n.
TEST(BumpMap, TiltsTheNormalAsTheDisplacedSurfaceWould) {
  constexpr int texels = 512;
  const TestImage wave(texels, 4, [](double u, double) { return Vec3d(0.5 + 0.5 * std::sin(2 * pi_d * u)); });
  for (const Vec3& edge_v : {Vec3{0, 1, 0}, Vec3{1, 1, 0}}) {
    const Vec3 edge_u{3, 0, 0};
    SceneDescription scene = world_of(rectangle({0, 0, 0}, edge_u, edge_v), {}, false);
    ImageTexture height;
    height.image = wave.texture_image();
    scene.materials[0].bump_map.map = add_texture(scene, height);
    scene.materials[0].bump_scale = 0.1f;
    const Scene world(std::move(scene));
    Random random(1);
    for (int i = 0; i < 200; ++i) {
      const Vec2 uv = random.square();
      const Vec3 target = uv.x * edge_u + uv.y * edge_v;
      const auto surface = seen(world, {target + Vec3(0, 0, 2), {0, 0, -1}});
      ASSERT_TRUE(surface);
      const double slope = 0.1 * 0.5 * 2 * pi_d * std::cos(2 * pi_d * static_cast<double>(uv.x));
      const Vec3d displaced = cross(Vec3d(edge_u) + slope * Vec3d(0, 0, 1), Vec3d(edge_v));
      expect_near(surface->shading.n, Vec3(glm::normalize(displaced)), 2e-3f);
    }
  }
}

// The same bump whether the height is a picture on uv or a colour at the vertices.
TEST(BumpMap, KnowsTheSlopeOfVertexColours) {
  Mesh mesh = polygon({{0, 0, 0}, {2, 0, 0}, {0, 1, 0}});
  mesh.colors = {Spectrum(0, 0, 0, 1), Spectrum(1, 1, 1, 1), Spectrum(0, 0, 0, 1)};
  SceneDescription scene = world_of(mesh, {}, false);
  scene.materials[0].bump_map.map = add_texture(scene, VertexColorTexture{});
  scene.materials[0].bump_scale = 0.5f;  // 0.5 up over 2 along x
  expect_near(looked_at(scene, {0.5f, 0.2f, 0}, {0.5f, 0.2f, 3}).shading.n,
              glm::normalize(Vec3(-0.25f, 0, 1)), 1e-3f);
}

TEST(ReflectingNormal, LetsEveryMirrorDirectionLeave) {
  Random random(2);
  int changed = 0;
  for (int i = 0; i < 100'000; ++i) {
    const Vec3 ng(random.direction());
    Vec3 ns(random.direction()), wo(random.direction());
    if (dot(ns, ng) < 0) ns = -ns;
    if (std::abs(dot(wo, ng)) < 1e-4f) continue;
    if (i % 2 == 0) wo = glm::normalize(wo - 0.99f * dot(wo, ng) * ng);  // grazing
    const float side = dot(wo, ng) < 0 ? -1.0f : 1.0f;
    const Vec3 n = reflecting_normal(ns, ng, wo);
    EXPECT_NEAR(glm::length(n), 1, 1e-5);
    EXPECT_GT(side * dot(wo, n), 0);
    const float height = side * dot(2 * dot(wo, n) * n - wo, ng);
    EXPECT_GT(height, 0) << dot(wo, ng);
    const Vec3 mirrored = 2 * dot(wo, ns) * ns - wo;
    const bool leaves = side * dot(wo, ns) > 0 && side * dot(mirrored, ng) > 0.011f;
    EXPECT_TRUE(!leaves || n == ns) << "changed without need";
    changed += n != ns;
  }
  EXPECT_GT(changed, 10'000);
  record({"Lobes", "a mirror's direction about a leaning normal goes below the surface", "0",
          fmt::format("0 of {} normals that were pulled back", changed)});
}

// No jump where the normal turns away from the viewer, or where it begins to be pulled: a seam would be seen.
TEST(ReflectingNormal, IsContinuous) {
  const Vec3 ng(0, 0, 1), wo = glm::normalize(Vec3(1, 0, 0.3f));
  Vec3 last = reflecting_normal({0, 0, 1}, ng, wo);
  constexpr int steps = 20'000;
  for (int i = 1; i < steps; ++i) {
    const float angle = -1.5f * static_cast<float>(i) / steps;
    const Vec3 n = reflecting_normal({std::sin(angle), 0, std::cos(angle)}, ng, wo);
    EXPECT_LT(glm::length(n - last), 1e-3f) << "at " << angle;
    last = n;
  }
}

}  // namespace
}  // namespace umbral
