// Procedural textures and images of many tiles: their values, bounds and what they ask of a surface.
#include <gtest/gtest.h>

#include "worlds.h"

namespace umbral {
namespace {

using namespace test;

template <class Kind>
std::vector<Kind> examples() {
  std::vector<Kind> kinds(3);
  kinds[1].low = rgb(0.9f, 0.1f, 0.3f);
  kinds[1].high = rgb(0.2f, 0.4f, 0.1f);
  kinds[1].scale = 3;
  kinds[2].space = TextureSpace::uv;
  return kinds;
}

template <class Kind>
class Procedural : public testing::Test {};
using Kinds = testing::Types<NoiseTexture, MarbleTexture, WoodTexture, StoneTexture>;
TYPED_TEST_SUITE(Procedural, Kinds);

TYPED_TEST(Procedural, KeepsItsBoundsAndReachesBothHalves) {
  for (const TypeParam& kind : examples<TypeParam>()) {
    SceneDescription scene;
    const Texture& texture = scene.textures[index_of(add_texture(scene, kind))];
    const TextureBounds bounds = texture.color_bounds();
    const float middle = 0.5f * (kind.low.r + kind.high.r);
    Random random(1);
    int above = 0;
    constexpr int n = 4000;
    for (int i = 0; i < n; ++i) {
      TexturePoint point(Vec2(random.in_cube(20)));
      point.p = Vec3(random.in_cube(20));
      const Spectrum color = texture.color(point);
      for (int c = 0; c < 3; ++c) {
        EXPECT_GE(color[c], bounds.low[c]);
        EXPECT_LE(color[c], bounds.high[c]);
      }
      above += color.r > middle;
    }
    EXPECT_GT(above, n / 50);
    EXPECT_LT(above, n - n / 50);
  }
}

TYPED_TEST(Procedural, LooksAtItsSpaceAlone) {
  for (const TypeParam& kind : examples<TypeParam>()) {
    SceneDescription scene;
    const Texture& texture = scene.textures[index_of(add_texture(scene, kind))];
    const bool by_uv = kind.space == TextureSpace::uv;
    EXPECT_EQ(texture.needs(), by_uv ? 0u : texture_needs::position);
    TexturePoint a(0.3f, 0.4f), b(7.3f, 9.9f);
    a.p = by_uv ? Vec3(1.2f, 3.4f, 5.6f) : Vec3(0.7f, 0.2f, 0.9f);
    b.p = by_uv ? Vec3(9, 8, 7) : a.p;
    if (by_uv) b.uv = a.uv;
    EXPECT_EQ(texture.color(a), texture.color(b));
  }
}

// Small steps make small changes but where a year ends or a cell does.
TYPED_TEST(Procedural, IsContinuousNearlyEverywhere) {
  SceneDescription scene;
  const Texture& texture = scene.textures[index_of(add_texture(scene, TypeParam{}))];
  Random random(2);
  int jumps = 0;
  constexpr int n = 5000;
  for (int i = 0; i < n; ++i) {
    TexturePoint a, b;
    a.p = Vec3(random.in_cube(10));
    b.p = a.p + 1e-4f * Vec3(random.direction());
    jumps += std::abs(texture.color(a).r - texture.color(b).r) > 0.02f;
  }
  EXPECT_LE(jumps, n / 200);
}

// The same wood in every place where the object stands.
TEST(ObjectSpace, MovesWithInstances) {
  SceneDescription description;
  WoodTexture wood;
  wood.scale = 5;
  const MaterialId material = add_matte(description, add_texture(description, wood));
  Shape shape;
  shape.kind = box({-1, -1, -1}, {1, 1, 1});
  shape.material = material;
  description.objects.push_back({"", {shape}});
  const Affine places[] = {translation({5, 0, 0}),
                           translation({0, 5, 0}) * rotation({0, 0, 1}, 1) * scaling({2, 2, 2})};
  for (const Affine& place : places) description.instances.push_back({static_cast<ObjectId>(0), place});
  const Scene scene(std::move(description));
  Random random(3);
  for (int i = 0; i < 200; ++i) {
    const Vec3d target(random.between(-0.9, 0.9), random.between(-0.9, 0.9), 1);
    Spectrum seen_first = black;
    for (const Affine& place : places) {
      const Ray ray{Vec3(place.point(target + Vec3d(0, 0, 2))), Vec3(place.vector({0, 0, -1}))};
      const auto surface = seen(scene, ray);
      ASSERT_TRUE(surface);
      LobeStack storage;
      const Spectrum color = albedo(scene.bsdf(*surface, storage));
      if (&place == &places[0])
        seen_first = color;
      else
        EXPECT_LT(std::abs(color.r - seen_first.r), 0.02f);
    }
  }
}

std::shared_ptr<const TextureImage> one_texel(float value) {
  TexelGrid<Float4> grid(1, 1);
  grid.set(0, 0, Spectrum(Vec3(value), 1));
  return std::make_shared<TextureImage>(TextureImage::Texels(std::move(grid)));
}

TEST(UdimTiles, LieOnTheirSquares) {
  auto tiles = std::make_shared<UdimTiles>();
  tiles->images.resize(12);
  tiles->images[0] = one_texel(0.25f);   // 1001
  tiles->images[1] = one_texel(0.5f);    // 1002
  tiles->images[11] = one_texel(0.75f);  // 1012
  ImageTexture kind;
  kind.image = tiles->images[0];
  kind.tiles = tiles;
  SceneDescription scene;
  const Texture& texture = scene.textures[index_of(add_texture(scene, kind))];
  EXPECT_EQ(texture.color({0.5f, 0.5f}).r, 0.25f);
  EXPECT_EQ(texture.color({1.5f, 0.9f}).r, 0.5f);
  EXPECT_EQ(texture.color({1.01f, 1.5f}).r, 0.75f);
  for (const Vec2& none : {Vec2(2.5f, 0.5f), Vec2(-0.5f, 0.5f), Vec2(0.5f, -0.1f), Vec2(0.5f, 1.5f),
                           Vec2(10.5f, 0.5f), Vec2(0.5f, 1e30f), Vec2(std::nanf(""), 0)})
    EXPECT_EQ(texture.color(none), Spectrum(0.0f));
  EXPECT_EQ(texture.color_bounds().low.r, 0);
  EXPECT_EQ(texture.color_bounds().high.r, 0.75f);
}

// A cone that meets the floor from above: its width in uv, in the world and in instances.
TEST(Footprint, IsTheWidthOfTheConeInUv) {
  for (const bool instanced : {false, true}) {
    SceneDescription description =
        world_of(rectangle({-1, -1, 0}, {4, 0, 0}, {0, 1, 0}), scaling({2, 2, 2}), instanced);
    ImageTexture image;
    image.image = one_texel(0.5f);
    image.filter = TextureFilter::mip;
    const TextureId map = add_texture(description, image);
    description.materials.clear();
    add_matte(description, map);
    const Scene scene(std::move(description));
    EXPECT_TRUE(scene.has_footprints());
    Ray ray{{0, -1, 3}, {0, 0, -1}};
    ray.width = 0.1f;
    ray.spread = 0.05f;  // 0.25 wide at the floor, where uv spans 8 by 2
    const auto down = seen(scene, ray);
    ASSERT_TRUE(down);
    EXPECT_NEAR(down->at.footprint, 0.25 / 4, 1e-5);
    EXPECT_NE(down->at.random, 0u);
    ray.d = glm::normalize(Vec3(0, 0.3f, -1));
    const auto aslant = seen(scene, ray);
    ASSERT_TRUE(aslant);
    const double cosine = 1 / std::sqrt(1.09), width = 0.1 + 0.05 * 3 / cosine;
    EXPECT_NEAR(aslant->at.footprint, width / std::sqrt(16 * cosine), 1e-5);
  }
}

}  // namespace
}  // namespace umbral
