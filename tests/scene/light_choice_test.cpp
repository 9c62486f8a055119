// Which light a scene asks: by power, none that shines forgotten, and densities that go with it.
#include <gtest/gtest.h>

#include "core/statistics.h"
#include "support/chi_square.h"
#include "support/stability.h"
#include "worlds.h"

namespace umbral {
namespace {

using namespace test;

SceneDescription many_lights() {
  SceneDescription scene = world_of(sphere({0, 0, 0}, 1), {}, false, grey(1));
  scene.shapes[0].two_sided = true;
  scene.lights.emplace_back(PointLight{{0, 5, 0}, grey(4)});
  scene.lights.emplace_back(SpotLight{{0, 0, 5}, {0, 0, 0}, grey(10), 30, 5});
  scene.lights.emplace_back(DistantLight{{0, -1, 0}, grey(0.5f)});
  EnvironmentLight environment;
  environment.radiance = grey(0.1f);
  environment.prepare();
  scene.environment = environment;
  return scene;
}

// The probability of each light, from the choices by an even grid of u; asserts that each tells the same.
std::vector<double> probabilities(const Scene& scene) {
  std::vector<double> told(scene.light_count(), -1), found(scene.light_count());
  constexpr int steps = 1 << 16;
  for (int i = 0; i < steps; ++i) {
    const auto choice = scene.choose_light(LightSelection::power, {}, (static_cast<float>(i) + 0.5f) / steps);
    double& probability = told[index_of(choice.light)];
    EXPECT_TRUE(probability < 0 || probability == choice.probability);
    probability = choice.probability;
    found[index_of(choice.light)] += 1.0 / steps;
  }
  for (std::size_t i = 0; i < told.size(); ++i) EXPECT_NEAR(std::max(told[i], 0.0), found[i], 2.0 / steps);
  return told;
}

TEST(LightChoice, HasProbabilitiesThatSumToOne) {
  const Scene scene(many_lights());
  double sum = 0;
  for (const double probability : probabilities(scene)) {
    EXPECT_GT(probability, 0);
    sum += probability;
  }
  EXPECT_NEAR(sum, 1, 1e-6);
}

TEST(LightChoice, PrefersPower) {
  SceneDescription description;
  for (const float intensity : {1.0f, 3.0f, 16.0f})
    description.lights.emplace_back(PointLight{{0, 0, 0}, grey(intensity)});
  const Scene scene(std::move(description));
  const std::vector<double> p = probabilities(scene);
  EXPECT_LT(p[0], p[1]);
  EXPECT_NEAR((p[2] - p[1]) / (p[1] - p[0]), 13.0 / 2, 1e-3) << "linear in the power";
  EXPECT_GT(p[2], 0.7);
}

TEST(LightChoice, OfOneLightIsSure) {
  SceneDescription description = world_of(sphere({0, 0, 0}, 1), {}, false, grey(1));
  const Scene scene(std::move(description));
  for (const float u : {0.0f, 0.5f, one_minus_epsilon}) {
    EXPECT_EQ(scene.choose_light(LightSelection::power, {}, u).light, static_cast<LightId>(0));
    EXPECT_EQ(scene.choose_light(LightSelection::power, {}, u).probability, 1);
  }
}

TEST(LightChoice, LeavesOutLightsThatAreBlack) {
  SceneDescription description;
  description.lights.emplace_back(PointLight{{0, 0, 0}, black});
  description.lights.emplace_back(PointLight{{0, 0, 0}, grey(1)});
  description.lights.emplace_back(DistantLight{{0, -1, 0}, black});
  const Scene scene(std::move(description));
  for (int i = 0; i < 1000; ++i) {
    const auto choice = scene.choose_light(LightSelection::power, {}, static_cast<float>(i) / 1000);
    EXPECT_EQ(choice.light, static_cast<LightId>(1));
    EXPECT_EQ(choice.probability, 1);
  }
}

TEST(LightChoice, AmongBlackLightsAloneIsEven) {
  SceneDescription description;
  for (int i = 0; i < 4; ++i) description.lights.emplace_back(PointLight{{0, 0, 0}, black});
  const Scene scene(std::move(description));
  for (const double p : probabilities(scene)) EXPECT_NEAR(p, 0.25, 1e-6);
}

// Chosen by the tree, with their true sum known.
TEST(LightChoice, OfThousandsOverTwelveDecadesOfPowerKeepsTheirIrradiance) {
  Random random(9);
  SceneDescription description;
  std::vector<PointLight> lamps;
  for (int i = 0; i < 3000; ++i)
    lamps.push_back({Vec3(random.in_cube(10)), grey(static_cast<float>(random.log_between(1e-6, 1e6)))});
  description.lights.assign(lamps.begin(), lamps.end());
  const Scene scene(std::move(description));
  double worst = 0;
  for (int k = 0; k < 3; ++k) {
    const LightReceiver receiver{Vec3(random.in_cube(10)), Vec3(random.direction())};
    double expected = 0;
    for (const PointLight& lamp : lamps) {
      const Vec3d way = Vec3d(lamp.position) - Vec3d(receiver.p);
      expected += static_cast<double>(lamp.intensity.g) * std::abs(dot(way, Vec3d(receiver.n))) /
                  std::pow(glm::length(way), 3);
    }
    Moments moments;
    for (int i = 0; i < 100'000; ++i) {
      const auto choice = scene.choose_light(LightSelection::tree, receiver, random.number());
      const auto sample = scene.sample_light(choice.light, receiver, random.square());
      ASSERT_TRUE(sample);
      moments.add(static_cast<double>(sample->radiance.g * std::abs(dot(sample->wi, receiver.n)) /
                                      choice.probability));
    }
    EXPECT_LT(std::abs(moments.mean - expected), 4.5 * moments.standard_error());
    EXPECT_LT((4.5 + 1.29) * moments.standard_error(), 0.02 * expected) << "too few draws";
    worst = std::max(worst, std::abs(moments.mean / expected - 1));
  }
  record({"Lights", "3000 lights of 1e-6 to 1e6 W/sr shine other than their sum",
          "equal within 4.5 σ, 2 % would show", fmt::format("{:.2g} %", 100 * worst)});
}

// A lamp in a wide landscape under the sun: against the sun's power, over all of the land, the lamp's is as nothing,
// but where it stands it is the brightest light.
TEST(LightChoice, NeverForgetsASmallLamp) {
  SceneDescription description;
  const MaterialId matte = add_matte(description, grey(0.5f));
  add_shape(description, rectangle({-1e4f, -1e4f, 0}, {2e4f, 0, 0}, {0, 2e4f, 0}), matte);
  description.lights.emplace_back(DistantLight{{0, 0, -1}, grey(1000)});
  description.lights.emplace_back(PointLight{{0, 0, 0.05f}, grey(10)});
  const Scene scene(std::move(description));
  EXPECT_GT(probabilities(scene)[1], 1e-3);
}

// One lamp under a sky whose power, over all the scene, is a hundred times as much: the tree leaves neither to less than a
// quarter.
TEST(LightChoice, NeverForgetsTheOnlyLampUnderASky) {
  SceneDescription description;
  const MaterialId matte = add_matte(description, grey(0.5f));
  add_shape(description, rectangle({-10, -10, 0}, {20, 0, 0}, {0, 20, 0}), matte);
  description.lights.emplace_back(PointLight{{0, 0, 1}, grey(1)});
  description.environment.emplace();
  description.environment->prepare();
  const Scene scene(std::move(description));
  const LightReceiver under{{0, 0, 0}, {0, 0, 1}};
  const auto expect = [&](LightSelection selection, float u, int light, float probability) {
    const LightChoice choice = scene.choose_light(selection, under, u);
    EXPECT_EQ(choice.light, static_cast<LightId>(light));
    EXPECT_NEAR(choice.probability, probability, 0.01);
  };
  expect(LightSelection::tree, 0.74f, 1, 0.75f);
  expect(LightSelection::tree, 0.76f, 0, 0.25f);
  expect(LightSelection::power, 0.01f, 0, 0.05f);
}

// A texture that shines in one spot only, between the places at which its power is estimated.
TEST(LightChoice, NeverForgetsATextureThatShinesInASpot) {
  SceneDescription description;
  add_matte(description, grey(0.5f));
  TexelGrid<Float4> grid(256, 256);
  grid.set(133, 101, Spectrum(1e4f));
  ImageTexture image;
  image.image = std::make_shared<TextureImage>(TextureImage::Texels(std::move(grid)));
  const TextureId map = add_texture(description, image);
  Shape screen;
  screen.kind = rectangle({0, 0, 0}, {1, 0, 0}, {0, 1, 0});
  screen.material = static_cast<MaterialId>(0);
  screen.emission.map = map;
  description.shapes.push_back(screen);
  description.lights.emplace_back(PointLight{{0, 0, 5}, grey(10)});
  const Scene scene(std::move(description));
  EXPECT_GT(probabilities(scene)[0], 1e-3);
}

TEST(LightChoice, GivesTheEnvironmentItsShareOfTheDensity) {
  const Scene scene(many_lights());
  const std::vector<double> p = probabilities(scene);
  Random random(1);
  for (int i = 0; i < 100; ++i)
    EXPECT_NEAR(scene.environment_pdf(LightSelection::power, {}, Vec3(random.direction())),
                p.back() / (4 * pi_d), 1e-6);
  const auto sample =
      scene.sample_light(static_cast<LightId>(scene.light_count() - 1), {0, 0, 0}, {0.2f, 0.7f});
  ASSERT_TRUE(sample);
  EXPECT_NEAR(scene.environment_pdf(LightSelection::power, {}, sample->wi), p.back() * sample->pdf, 1e-6);
  EXPECT_EQ(scene.background(sample->wi), sample->radiance);
  EXPECT_TRUE(scene.has_environment());
}

TEST(LightChoice, WithoutEnvironmentHasNoBackground) {
  const Scene scene(world_of(sphere({0, 0, 0}, 1), {}, false));
  EXPECT_FALSE(scene.has_environment());
  EXPECT_EQ(scene.background({0, 0, 1}), black);
  EXPECT_EQ(scene.environment_pdf(LightSelection::power, {}, {0, 0, 1}), 0);
}

TEST(Features, AreThoseThatTheSceneUses) {
  EXPECT_EQ(Scene(world_of(box({0, 0, 0}, {1, 1, 1}), {}, false)).features(),
            std::vector<std::string>{"matte"});
  SceneDescription description = many_lights();
  CheckerTexture checker;
  const TextureId map = add_texture(description, checker);
  description.materials[0].alpha.map = map;
  description.objects.push_back({"", {}});
  description.instances.push_back({static_cast<ObjectId>(0), Affine{}});
  const std::vector<std::string> expected{"alpha",      "analytic shapes", "environment", "instances",
                                          "light tree", "matte",           "textures"};
  EXPECT_EQ(Scene(std::move(description)).features(), expected);
}

}  // namespace
}  // namespace umbral
