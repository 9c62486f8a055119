// Textures that are laid through space: where in uv a place lies, and what they ask of a surface.
#include <gtest/gtest.h>

#include "scene/relative_to_camera.h"
#include "worlds.h"

namespace umbral {
namespace {

using namespace test;

TexturePoint at(const Vec3& p) {
  TexturePoint point(9.9f, 8.8f);
  point.p = p;
  return point;
}

struct Laid {
  SceneDescription scene;
  TextureId id = TextureId::none;

  explicit Laid(ProjectedTexture projected, CheckerTexture checker = {}) {
    checker.uv_scale = {1, 1};
    projected.texture.map = add_texture(scene, checker);
    id = add_texture(scene, projected);
  }
  const Texture& texture() const { return scene.textures[index_of(id)]; }
  Vec2 uv(const Vec3& p) const { return texture().placed(at(p)); }
};

void expect_near(const Vec2& a, const Vec2& b) {
  EXPECT_LT(glm::length(a - b), 2e-6f) << a.x << ' ' << a.y << ", not " << b.x << ' ' << b.y;
}

TEST(ProjectedTexture, LiesOnAPlane) {
  ProjectedTexture plane;
  plane.origin = {1, 2, 3};
  plane.x = {0, 0, 2};
  plane.y = {0, -3, 0};
  const Laid laid(plane);
  expect_near(laid.uv({1, 2, 3}), {0, 0});
  expect_near(laid.uv({7, 2, 3.5f}), {1, 0});
  expect_near(laid.uv({-4, 1, 3}), {0, 3});
}

TEST(ProjectedTexture, GoesRoundToTheRightAsSeenFromOutside) {
  ProjectedTexture round;
  round.projection = Projection::cylindrical;
  const Laid cylinder(round);
  expect_near(cylinder.uv({0, 0.3f, 2}), {0, 0.3f});
  expect_near(cylinder.uv({2, -1.5f, 0}), {0.25f, -1.5f});
  expect_near(cylinder.uv({0, 0, -1}), {0.5f, 0});
  expect_near(cylinder.uv({-1, 0, 1}), {0.875f, 0});
  round.projection = Projection::spherical;
  const Laid sphere(round);
  expect_near(sphere.uv({0, 0, 3}), {0, 0.5f});
  expect_near(sphere.uv({3, 3, 0}), {0.25f, 0.75f});
  expect_near(sphere.uv({0, -1, -1}), {0.5f, 0.25f});
  EXPECT_NEAR(sphere.uv({0, 7, 0}).y, 1, 1e-6);
  EXPECT_NEAR(sphere.uv({0, -7, 0}).y, 0, 1e-6);
  for (const float almost : {-1e-20f, -1e-7f}) EXPECT_LT(sphere.uv({almost, 0, 1}).x, 1);
}

TEST(ProjectedTexture, GivesWhatItsTextureGivesThere) {
  CheckerTexture checker;
  checker.even = rgb(1, 0.5f, 0.25f);
  checker.odd = rgb(0, 0.1f, 0.2f);
  const Laid laid(ProjectedTexture{}, checker);
  const Texture& inner = laid.scene.textures[0];
  Random random(3);
  for (int i = 0; i < 100; ++i) {
    const Vec3 p(random.in_cube(4));
    EXPECT_EQ(laid.texture().color(at(p)), inner.color(Vec2(p)));
    EXPECT_EQ(laid.texture().number(at(p)), inner.number(Vec2(p)));
  }
  EXPECT_EQ(laid.texture().number_bounds().high, inner.number_bounds().high);
  EXPECT_EQ(laid.texture().color_bounds().low, inner.color_bounds().low);
}

TEST(ProjectedTexture, AsksForThePlaceInsteadOfUv) {
  CheckerTexture second;
  second.uv_set = 1;
  ProjectedTexture plane;
  plane.x = {4, 0, 0};
  const Laid laid(plane, second);
  EXPECT_EQ(laid.texture().needs(), texture_needs::position);
  expect_near(laid.uv({0.5f, 7, 0}), {2, 7});
  const TextureStep step = laid.texture().step(), inner = laid.scene.textures[0].step();
  EXPECT_EQ(step.uv, infinity);
  EXPECT_FLOAT_EQ(step.position, inner.uv / 4);
}

// A ball 100 units from the origin, which is nearer to its camera than to the origin.
TEST(ProjectedTexture, StaysInTheWorldWhereverTheCameraIs) {
  SceneDescription scene;
  scene.camera = camera({100, 0, 5}, {100, 0, 0}, 40);
  ProjectedTexture plane;
  plane.texture.map = add_texture(scene, CheckerTexture{});
  const TextureId laid = add_texture(scene, plane);
  const MaterialId matte = add_matte(scene, grey(0.5f));
  add_shape(scene, sphere({100, 0, 0}, 1), matte);
  EXPECT_EQ(relative_to_camera(scene).camera.position, scene.camera.position);
  scene.textures.resize(index_of(laid));
  EXPECT_EQ(relative_to_camera(scene).camera.position, Vec3(0)) << "by uv alone: may be moved";
}

}  // namespace
}  // namespace umbral
