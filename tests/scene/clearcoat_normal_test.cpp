// The normal of a clearcoat: by its own map, whatever the map of what it covers, and always above the true surface.
#include <gtest/gtest.h>

#include "scene/surface_detail.h"
#include "worlds.h"

namespace umbral {
namespace {

using namespace test;

constexpr float left = 0.3f, up = 0.2f;
const Vec3 leans_left = glm::normalize(Vec3(-left, 0, 1)), leans_up = glm::normalize(Vec3(0, up, 1));

// A map of one normal everywhere.
TextureId one_normal(SceneDescription& scene, const Vec3& n) {
  CheckerTexture map;
  map.even = map.odd = Spectrum((n + 1.0f) / 2.0f, 0);
  return add_texture(scene, map);
}

// A square in the plane z = 0 whose uv are x and y, of coated plastic.
SceneDescription coated_square() {
  SceneDescription scene = world_of(rectangle({0, 0, 0}, {1, 0, 0}, {0, 1, 0}), {}, false);
  Principled lobe;
  lobe.clearcoat = 0.5f;
  scene.materials[0].lobe = lobe;
  return scene;
}

struct Normals {
  Vec3 base, coat;
};

// As the lobe has them; from that far along x.
Normals normals_of(const SceneDescription& description, float from = 0, float height = 2) {
  const Scene scene{SceneDescription(description)};
  const Vec3 target(0.4f, 0.3f, 0);
  const auto surface = seen(scene, {target + Vec3(from, 0, height), {-from, 0, -height}});
  EXPECT_TRUE(surface);
  if (!surface) return {};
  LobeStack room;
  const auto& lobe = std::get<Principled>(scene.bsdf(*surface, room));
  return {surface->shading.n, surface->shading.to_world(lobe.clearcoat_normal)};
}

void expect_near(const Vec3& a, const Vec3& b, float tolerance = 2e-5f) {
  EXPECT_LT(glm::length(a - b), tolerance)
      << a.x << " " << a.y << " " << a.z << " instead of " << b.x << " " << b.y << " " << b.z;
}

TEST(ClearcoatNormal, IsThatOfItsOwnMap) {
  SceneDescription scene = coated_square();
  Material& material = scene.materials[0];
  const auto expect = [&](const Vec3& base, const Vec3& coat) {
    for (const float height : {2.0f, -2.0f}) {
      const Normals n = normals_of(scene, 0, height);
      expect_near(n.base, base);
      expect_near(n.coat, coat);
    }
  };
  const Vec3 flat{0, 0, 1};
  expect(flat, flat);
  material.normal_map.map = one_normal(scene, leans_left);
  expect(leans_left, flat);
  material.clearcoat_normal_map.map = one_normal(scene, leans_up);
  expect(leans_left, leans_up);
  material.clearcoat_normal_scale = 0.5f;
  expect(leans_left, glm::normalize(Vec3(0, up / 2, 1)));
  material.normal_map = {level_normal};
  expect(flat, glm::normalize(Vec3(0, up / 2, 1)));
  material.lobe = Principled{};  // no coat
  material.normal_map.map = one_normal(scene, leans_left);
  expect(leans_left, leans_left);
}

// The coat lies on the surface that a bump map bends.
TEST(ClearcoatNormal, FollowsABumpMap) {
  SceneDescription scene = coated_square();
  const TestImage slope(2, 2, [](double u, double) { return Vec3d(u < 0.5 ? 0 : 1); });
  scene.materials[0].bump_map.map = add_texture(scene, slope.texture());
  scene.materials[0].bump_scale = 0.1f;
  const Vec3 bent = normals_of(scene).base;
  EXPECT_LT(bent.x, -0.1f);
  expect_near(normals_of(scene).coat, bent);
  scene.materials[0].normal_map.map = one_normal(scene, leans_up);
  expect_near(normals_of(scene).coat, bent);
  EXPECT_GT(normals_of(scene).base.y, 0.1f);
}

TEST(ClearcoatNormal, CostsNothingWhereItIsThatOfAll) {
  SceneDescription scene = coated_square();
  Material& material = scene.materials[0];
  const auto has_its_own = [&] {
    const Scene made{SceneDescription(scene)};
    const auto surface = seen(made, {{0.4f, 0.3f, 2}, {0, 0, -1}});
    return surface && (surface->detail & surface_detail::clearcoat_normal) != 0;
  };
  EXPECT_FALSE(has_its_own());
  material.normal_map.map = one_normal(scene, leans_left);
  EXPECT_TRUE(has_its_own());
  material.clearcoat_normal_map = material.normal_map;
  EXPECT_FALSE(has_its_own());
  material.clearcoat_normal_scale = 0.5f;
  EXPECT_TRUE(has_its_own());
  material.lobe = Principled{};
  EXPECT_FALSE(has_its_own());
  material.maps.push_back({detail::set_from_texture<&Principled::clearcoat>, material.normal_map.map});
  EXPECT_TRUE(has_its_own());
  material.lobe = Conductor{};
  material.maps.clear();
  EXPECT_FALSE(has_its_own());
}

// Each is pulled for itself to where its mirror direction leaves.
TEST(ClearcoatNormal, ReflectsAboveTheTrueSurface) {
  SceneDescription scene = coated_square();
  scene.materials[0].normal_map.map = one_normal(scene, leans_up);
  scene.materials[0].clearcoat_normal_map.map = one_normal(scene, glm::normalize(Vec3(-2, 0, 1)));
  for (const float from : {0.5f, 2.0f, 20.0f}) {
    const Normals n = normals_of(scene, from);
    const Vec3 wo = glm::normalize(Vec3(from, 0, 2));
    EXPECT_GT(dot(wo, n.coat), 0);
    EXPECT_GT((2 * dot(wo, n.coat) * n.coat - wo).z, 0) << from;
    expect_near(n.base, reflecting_normal(leans_up, {0, 0, 1}, wo));
  }
}

// What a texture of the coat's normals asks of a point is there.
TEST(ClearcoatNormal, UsesTheUvSetOfItsTexture) {
  Mesh mesh = polygon({{-2, -2, 0}, {4, -2, 0}, {-2, 4, 0}});
  for (const Vec3& p : mesh.positions) {
    mesh.uvs.emplace_back(p);
    mesh.uvs1.emplace_back(p.y, -p.x);
  }
  SceneDescription scene = world_of(mesh, {}, false);
  scene.materials[0] = coated_square().materials[0];
  CheckerTexture map;
  map.even = map.odd = Spectrum((leans_left + 1.0f) / 2.0f, 0);
  map.uv_set = 1;
  scene.materials[0].clearcoat_normal_map.map = add_texture(scene, map);
  expect_near(normals_of(scene).coat, glm::normalize(Vec3(0, -left, 1)));
}

}  // namespace
}  // namespace umbral
