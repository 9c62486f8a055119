// Different ways to compute the same image agree: strategies, roulette, and the local model with one bounce.
#include <map>
#include <memory>
#include <utility>

#include "integrators/blinn_phong.h"
#include "support/render_image.h"
#include "support/scene_kit.h"
#include "support/stability.h"
#include "support/ways.h"

namespace umbral::test {
namespace {

// A corner of matte and shiny textured surfaces around a glossy ball, under a rectangle, beside a disk and in the open.
SceneDescription studio() {
  SceneDescription scene;
  scene.camera = camera({1.6f, -2.6f, 1.9f}, {-0.1f, 0.2f, 0.5f}, 42);
  const TextureId colors = add_texture(scene, TestImage(8, 8, 0.1, 0.9, 7).texture());
  ImageTexture shine = TestImage(4, 4, 0, 1, 8).texture();
  shine.factor = 30;
  shine.bias = 2;
  shine.channel = TextureChannel::r;
  const TextureId exponents = add_texture(scene, shine);
  CheckerTexture checker;
  checker.even = grey(0.5f);
  checker.odd = rgb(0.1f, 0.2f, 0.4f);
  const TextureId squares = add_texture(scene, checker);

  const MaterialId floor = add_material(scene, Lambert{}, {{"reflectance", squares}});
  const MaterialId wall = add_material(scene, BlinnPhong{black, grey(0.4f), 20, white}, {{"kd", colors}});
  const MaterialId ball = add_material(scene, BlinnPhong{rgb(0.4f, 0.2f, 0.1f), grey(0.5f), 10, white},
                                       {{"exponent", exponents}});
  const MaterialId lamp = add_matte(scene, black);
  add_shape(scene, rectangle({-2, -2, 0}, {4, 0, 0}, {0, 4, 0}), floor);
  add_shape(scene, rectangle({-2, 1.5f, 0}, {4, 0, 0}, {0, 0, 3}), wall);
  add_shape(scene, sphere({0.2f, 0, 0.5f}, 0.5f), ball);
  add_shape(scene, rectangle({-1.6f, -2, 2.4f}, {0, 3, 0}, {3.2f, 0, 0}), lamp, rgb(2, 1.5f, 1));
  add_shape(scene, disk({-1.9f, -0.3f, 1.3f}, {1, -0.3f, -0.5f}, 0.7f), lamp, rgb(0.8f, 1.2f, 2));

  scene.environment.emplace();
  scene.environment->image = TestImage(16, 8, 0.05, 0.25, 9).texture_image();
  scene.environment->prepare();
  return scene;
}

// Tiles of 8 × 8 pixels.
GateSettings coarse() {
  GateSettings settings;
  settings.tiles = 2;
  return settings;
}

// What `render` made before is not made again.
RenderReplicate remembered(const RenderReplicate& render) {
  const auto images = std::make_shared<std::map<std::pair<std::uint64_t, int>, PixelImage>>();
  return [=](std::uint64_t seed, int effort) {
    const auto [image, is_new] = images->try_emplace({seed, effort});
    if (is_new) image->second = render(seed, effort);
    return image->second;
  };
}

TEST(StrategyAgreement, BsdfIsMisIsLight) {
  const Scene scene(studio());
  PathIntegrator mis, bsdf, light;
  bsdf.strategy = Strategy::bsdf;
  light.strategy = Strategy::light;
  const auto by = [&](PathIntegrator& path) { return SmallRender{scene, path, SamplerKind::sobol, 640}; };
  const RenderReplicate by_mis = remembered(by(mis));
  GateSettings half = coarse();
  half.alpha /= 2;
  EXPECT_TRUE(same_mean(by_mis, by(bsdf), half));
  EXPECT_TRUE(same_mean(by_mis, by(light), half));
}

TEST(RouletteAgreement, OnIsOff) {
  const Scene scene(studio());
  PathIntegrator on, off;
  on.max_depth = off.max_depth = 6;
  on.roulette_depth = 1;
  off.roulette_depth = 1000;
  EXPECT_TRUE(same_mean(SmallRender{scene, on, SamplerKind::sobol, 256},
                        SmallRender{scene, off, SamplerKind::sobol, 256}, coarse()));
  record({"Accumulation", "Russian roulette from the first bounce on changes the picture",
          "equal within noise, 0.5 % would show", "equal", "chunky #1018, Moer #77"});
}

// Lights of every kind, near and far, strong and weak, two-sided and instanced.
SceneDescription lit_studio() {
  SceneDescription scene = studio();
  const MaterialId lamp = add_matte(scene, black);
  scene.lights.emplace_back(PointLight{{1.2f, -1.5f, 1.9f}, rgb(0.6f, 0.4f, 0.2f)});
  scene.lights.emplace_back(SpotLight{{0, -2, 2.2f}, {0, 0, 0}, rgb(3, 3, 1), 40, 20});
  scene.lights.emplace_back(DistantLight{{0.3f, 0.4f, -1}, grey(0.2f)});
  for (int i = 0; i < 12; ++i)
    add_shape(scene, sphere({-1.5f + 0.27f * static_cast<float>(i), 1.2f, 0.3f}, 0.05f), lamp,
              rgb(3, 0.3f * static_cast<float>(i), 1));
  add_shape(scene, rectangle({1.6f, -1, 0.4f}, {0, 0.5f, 0}, {0, 0, 0.8f}), lamp, rgb(1, 2, 3)).two_sided =
      true;
  add_shape(scene,
            polygon({{-1.8f, -1.5f, 0.2f}, {-1.2f, -1.7f, 0.3f}, {-1.1f, -1.2f, 0.9f}, {-1.7f, -1, 0.8f}}),
            lamp, rgb(4, 1, 2))
      .two_sided = true;
  return scene;
}

TEST(LightChoiceAgreement, TreeIsUniformIsPower) {
  const Scene scene(lit_studio());
  PathIntegrator tree, power, uniform;
  power.light_choice = LightSelection::power;
  uniform.light_choice = LightSelection::uniform;
  const auto by = [&](PathIntegrator& path, int spp) {
    return SmallRender{scene, path, SamplerKind::sobol, spp};
  };
  const RenderReplicate by_tree = remembered(by(tree, 384));
  GateSettings half = coarse();
  half.alpha /= 2;
  EXPECT_TRUE(same_mean(by_tree, by(uniform, 768), half));
  EXPECT_TRUE(same_mean(by_tree, by(power, 768), half));
}

// The local model by the physical convention is the path tracer cut at one bounce. It looks at every light, the
// path tracer at one of them.
TEST(LocalModelAgreement, PhysicalIsOneBounce) {
  SceneDescription description = studio();
  description.lights.emplace_back(PointLight{{1.5f, -1, 1.5f}, rgb(3, 2, 4)});
  description.lights.emplace_back(SpotLight{{0, -2, 2}, {0, 0, 0}, rgb(5, 5, 2), 40, 20});
  const Scene scene(std::move(description));
  PathIntegrator path;
  path.max_depth = 1;
  BlinnPhongIntegrator local;
  local.convention = Convention::physical;
  EXPECT_TRUE(same_mean(SmallRender{scene, path, SamplerKind::sobol, 256},
                        SmallRender{scene, local, SamplerKind::sobol, 256}, coarse()));
}

}  // namespace
}  // namespace umbral::test
