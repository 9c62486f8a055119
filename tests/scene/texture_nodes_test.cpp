// Textures made from other textures, and what meshes carry for them.
#include <gtest/gtest.h>

#include "worlds.h"

namespace umbral {
namespace {

using namespace test;

CheckerTexture checker(const Spectrum& even, const Spectrum& odd) {
  CheckerTexture texture;
  texture.even = even;
  texture.odd = odd;
  texture.uv_scale = {2, 1};
  return texture;
}

constexpr float left = 0.25f, right = 0.75f;  // u of the even and the odd square

TEST(ScaleTexture, MultipliesColoursAndNumbers) {
  SceneDescription scene;
  const TextureId base = add_texture(scene, checker(rgb(0.2f, 0.4f, 0.6f), rgb(1, 0.5f, 0)));
  ScaleTexture tinted;
  tinted.texture.map = base;
  tinted.scale.value = rgb(0.5f, 1, 2);
  const Texture& texture = scene.textures[index_of(add_texture(scene, tinted))];
  EXPECT_EQ(Vec3(texture.color({left, 0})), Vec3(0.2f * 0.5f, 0.4f, 1.2f));
  EXPECT_EQ(Vec3(texture.color({right, 0})), Vec3(0.5f, 0.5f, 0));
  EXPECT_FLOAT_EQ(texture.number({left, 0}), luminance(rgb(0.2f, 0.4f, 0.6f)) * luminance(rgb(0.5f, 1, 2)));
}

// As glTF multiplies the alpha of a texture by that of a colour.
TEST(ScaleTexture, TakesFromEachInputItsOwnChannel) {
  SceneDescription scene;
  CheckerTexture base = checker({0.1f, 0.2f, 0.3f, 0.8f}, {0, 0, 0, 1});
  base.channel = TextureChannel::a;
  ScaleTexture product;
  product.texture.map = add_texture(scene, base);
  product.scale.value = grey(0.5f);
  const Texture& texture = scene.textures[index_of(add_texture(scene, product))];
  EXPECT_FLOAT_EQ(texture.number({left, 0}), 0.4f);
  EXPECT_FLOAT_EQ(texture.number_bounds().low, 0.4f);
  EXPECT_FLOAT_EQ(texture.number_bounds().high, 0.5f);
}

TEST(MixTexture, GoesFromOneInputToTheOther) {
  SceneDescription scene;
  MixTexture blend;
  blend.a.value = rgb(1, 0, 0);
  blend.b.map = add_texture(scene, checker(grey(0.25f), grey(0.5f)));
  blend.amount.map = add_texture(scene, checker(grey(0.5f), grey(1)));
  const Texture& texture = scene.textures[index_of(add_texture(scene, blend))];
  EXPECT_EQ(Vec3(texture.color({left, 0})), Vec3(0.625f, 0.125f, 0.125f));
  EXPECT_EQ(Vec3(texture.color({right, 0})), Vec3(0.5f));
}

TEST(DirectionTexture, IsTheAngleInRedAndGreen) {
  const auto at = [](const Vec2& direction, float rotation) {
    SceneDescription scene;
    DirectionTexture angles;
    angles.texture.map =
        add_texture(scene, checker(rgb((direction.x + 1) / 2, (direction.y + 1) / 2, 0), black));
    angles.rotation = rotation;
    return scene.textures[index_of(add_texture(scene, angles))].number({left, 0});
  };
  EXPECT_NEAR(at({1, 0}, 0), 0, 1e-4);
  EXPECT_NEAR(at({0, 1}, 0), 90, 1e-4);
  EXPECT_NEAR(at({-0.6f, -0.6f}, 0), 225, 1e-3);
  EXPECT_NEAR(at({0.5f, -0.5f}, 30), 345, 1e-3);
  EXPECT_NEAR(at({0, 0.2f}, 300), 30, 1e-3);
}

TEST(RampTexture, FindsTheColourBetweenStops) {
  const auto at = [](float number, RampInterpolation interpolation) {
    SceneDescription scene;
    RampTexture ramp;
    ramp.input.value = number;
    ramp.stops = {{0.2f, rgb(1, 0, 0)}, {0.4f, rgb(0, 1, 0)}, {0.8f, rgb(0, 0, 1)}};
    ramp.interpolation = interpolation;
    return Vec3(scene.textures[index_of(add_texture(scene, ramp))].color({0, 0}));
  };
  const auto expect_near = [](const Vec3& a, const Vec3& b) {
    EXPECT_LT(glm::length(a - b), 1e-6f) << a.x << " " << a.y;
  };
  for (const auto interpolation :
       {RampInterpolation::linear, RampInterpolation::smooth, RampInterpolation::constant}) {
    expect_near(at(-3, interpolation), {1, 0, 0});
    expect_near(at(0.2f, interpolation), {1, 0, 0});
    expect_near(at(0.4f, interpolation), {0, 1, 0});
    expect_near(at(9, interpolation), {0, 0, 1});
  }
  expect_near(at(0.5f, RampInterpolation::linear), {0, 0.75f, 0.25f});
  expect_near(at(0.5f, RampInterpolation::smooth), {0, 1 - 0.15625f, 0.15625f});
  expect_near(at(0.79f, RampInterpolation::constant), {0, 1, 0});
}

// Bounds are what readers check ranges by: no graph of textures may leave its own.
TEST(TextureNodes, StayWithinTheirBounds) {
  Random random(1);
  const auto color = [&] { return Spectrum(Vec3(random.in_cube(2)), 0); };
  for (int i = 0; i < 200; ++i) {
    SceneDescription scene;
    const auto any = [&](auto& input) {
      if (random.coin() && !scene.textures.empty())
        input.map = static_cast<TextureId>(random.below(scene.textures.size()));
    };
    add_texture(scene, checker(color(), color()));
    add_texture(scene, VertexColorTexture{});
    for (int k = 0; k < 5; ++k) {
      ScaleTexture product;
      product.texture.value = color();
      any(product.texture);
      any(product.scale);
      add_texture(scene, product);
      MixTexture blend;
      blend.a.value = color();
      any(blend.a);
      any(blend.b);
      blend.amount.value = random.number();
      add_texture(scene, blend);
      RampTexture ramp;
      any(ramp.input);
      ramp.stops = {{-1, color()}, {0, color()}, {1.5f, color()}};
      ramp.interpolation = static_cast<RampInterpolation>(random.below(3));
      add_texture(scene, ramp);
    }
    for (const Texture& texture : scene.textures)
      for (int k = 0; k < 20; ++k) {
        TexturePoint point(random.square());
        point.color = Spectrum(random.number(), random.number(), random.number(), random.number());
        const TextureBounds bounds = texture.color_bounds();
        const Range range = texture.number_bounds();
        const Spectrum value = texture.color(point);
        const float slack = 1e-5f * std::max(1.0f, max_component(glm::abs(value)));
        for (int c = 0; c < 3; ++c) {
          EXPECT_GE(value[c], bounds.low[c] - slack);
          EXPECT_LE(value[c], bounds.high[c] + slack);
        }
        EXPECT_GE(texture.number(point), range.low - slack);
        EXPECT_LE(texture.number(point), range.high + slack);
      }
  }
}

// What is seen at a hit: both uv, the colour and the place in the object, wherever it stands.
TEST(MeshAttributes, AreInterpolatedAtHits) {
  Mesh mesh = polygon({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}});
  mesh.uvs = {{0, 0}, {1, 0}, {0, 1}};
  mesh.uvs1 = {{5, 5}, {7, 5}, {5, 9}};
  mesh.colors = {{1, 0, 0, 1}, {0, 1, 0, 0.5f}, {0, 0, 1, 0}};
  for (const bool instanced : {false, true}) {
    const Affine place = translation({3, 4, 5}) * scaling({2, 2, 2});
    SceneDescription description = world_of(mesh, place, instanced);
    CheckerTexture second = checker(grey(0.1f), grey(0.2f));
    second.uv_set = 1;
    ScaleTexture product;
    product.texture.map = add_texture(description, VertexColorTexture{});
    product.scale.map = add_texture(description, second);
    const TextureId map = add_texture(description, product);
    description.materials[0] = {"", Lambert{}, {}, {1}};
    for_each_material_parameter(description.materials[0], [&](const ParameterInfo& info, auto& value) {
      if constexpr (requires { value.map; })
        if (std::string(info.name) == "reflectance") value.map = map;
    });
    const Scene scene(std::move(description));
    const Vec3 target(place.point({0.25, 0.5, 0}));
    const auto surface = seen(scene, {target + Vec3(0, 0, 2), {0, 0, -1}});
    ASSERT_TRUE(surface);
    EXPECT_LT(glm::length(surface->at.uv - Vec2(0.25f, 0.5f)), 1e-5f);
    EXPECT_LT(glm::length(surface->at.uv1 - Vec2(5.5f, 7)), 1e-4f);
    EXPECT_LT(glm::length(surface->at.color - Spectrum(0.25f, 0.25f, 0.5f, 0.375f)), 1e-5f);
    LobeStack room;
    const Spectrum reflectance = albedo(scene.bsdf(*surface, room));
    const float square = std::fmod(std::floor(2 * 5.5f) + std::floor(7.0f), 2.0f) == 0 ? 0.1f : 0.2f;
    EXPECT_NEAR(reflectance.b, 0.5f * square, 1e-5f);
  }
}

// The opacity of a mesh may come from its colours: of the same hits, in shadows too.
TEST(MeshAttributes, AreSeenByOpacity) {
  Mesh mesh = polygon({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}});
  mesh.colors = {
      {0, 0, 0, 0}, {1, 1, 1, 1}, {0, 0, 0, 0}};  // alpha is the barycentric coordinate of the second
  for (const bool instanced : {false, true}) {
    SceneDescription description = world_of(mesh, {}, instanced);
    VertexColorTexture color;
    color.channel = TextureChannel::a;
    description.materials[0].alpha.map = add_texture(description, color);
    description.materials[0].alpha_mode = AlphaMode::mask;
    const Scene scene(std::move(description));
    for (const float x : {0.1f, 0.4f, 0.49f, 0.51f, 0.6f, 0.9f}) {
      const Ray ray{{x, 0.05f, 1}, {0, 0, -1}};
      EXPECT_EQ(scene.occluded(ray), x > 0.5f) << x;
      EXPECT_EQ(scene.intersect(ray).has_value(), x > 0.5f) << x;
    }
  }
}

}  // namespace
}  // namespace umbral
