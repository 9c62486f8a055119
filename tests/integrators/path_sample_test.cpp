// Single samples of the path tracer: layers, exact cases, and paths that could go on for ever.
#include <gtest/gtest.h>

#include "integrators/blinn_phong.h"
#include "integrators/path.h"
#include "support/scene_kit.h"

namespace umbral::test {
namespace {

SceneDescription shiny_ball() {
  SceneDescription scene;
  add_shape(scene, sphere({0, 0, 0.5f}, 0.5f),
            add_material(scene, BlinnPhong{rgb(0.6f, 0.5f, 0.4f), rgb(0.3f, 0.4f, 0.5f), 12, white}));
  add_shape(scene, rectangle({-4, -4, 0}, {8, 0, 0}, {0, 8, 0}), add_matte(scene, rgb(0.2f, 0.5f, 0.7f)));
  return scene;
}

// Rays from a camera over the scene, with the sampler that each goes on with.
template <class Visit>
void for_each_sample(const CameraSettings& settings, SamplerKind kind, const Visit& visit) {
  const Camera camera(settings, 16, 16);
  for (std::uint32_t i = 0; i < 1024; ++i) {
    Sampler sampler(kind, {7, i % 16, i / 16 % 16, 0, i / 256});
    const Vec2 offset = sampler.next2d();
    const Ray ray =
        camera.ray(Vec2{static_cast<float>(i % 16), static_cast<float>(i / 16 % 16)} + offset, {0, 0});
    visit(ray, sampler);
  }
}

const CameraSettings over_ball = camera({1, -2, 1.5f}, {0, 0, 0.3f}, 50);

// Both do the same sum, but for the rounding of its products.
TEST(PathSample, OneDeltaLightIsTheLocalModelExactly) {
  const LightKinds lights[] = {PointLight{{1.5f, -1, 2}, rgb(5, 6, 7)},
                               SpotLight{{-1, -1.5f, 2}, {0, 0, 0.4f}, rgb(5, 6, 7), 50, 30},
                               DistantLight{{0.4f, 0.5f, -1}, rgb(1, 2, 3)}};
  for (const LightKinds& light : lights) {
    SceneDescription description = shiny_ball();
    description.lights.push_back(light);
    const Scene scene(std::move(description));
    PathIntegrator path;
    path.max_depth = 1;
    BlinnPhongIntegrator local;
    local.convention = Convention::physical;
    int lit = 0;
    for_each_sample(over_ball, SamplerKind::sobol, [&](const Ray& ray, const Sampler& sampler) {
      Sampler of_path = sampler, of_local = sampler;
      const Spectrum a = path.radiance(scene, ray, of_path, {}), b = local.radiance(scene, ray, of_local, {});
      for (int c = 0; c < 3; ++c) EXPECT_NEAR(a[c], b[c], 4e-7f * b[c]);
      lit += !is_black(a);
    });
    EXPECT_GT(lit, 300);
  }
}

SceneDescription room_with_lamp() {
  SceneDescription scene = shiny_ball();
  add_shape(scene, rectangle({-1, -1, 2}, {0, 2, 0}, {2, 0, 0}), add_matte(scene, grey(0.3f)), rgb(2, 3, 4));
  scene.environment.emplace();
  scene.environment->radiance = grey(0.2f);
  scene.environment->prepare();
  return scene;
}

TEST(PathSample, LayersAddUp) {
  const Scene scene(room_with_lamp());
  PathIntegrator path;
  int layered[3] = {0, 0, 0};
  for_each_sample(
      camera({1, -3, 1.5f}, {0, 0, 1}, 70), SamplerKind::sobol, [&](const Ray& ray, Sampler sampler) {
        Sampler again = sampler;
        std::array<Spectrum, 3> layers{black, black, black};
        const Spectrum whole = path.radiance(scene, ray, sampler, layers);
        EXPECT_EQ(whole, path.radiance(scene, ray, again, {}));  // asking for layers changes nothing
        const Spectrum sum = layers[0] + layers[1] + layers[2];
        for (int c = 0; c < 3; ++c) EXPECT_NEAR(sum[c], whole[c], 1e-6f * whole[c]);
        for (int i = 0; i < 3; ++i) layered[i] += !is_black(layers[i]);
      });
  for (const int count : layered) EXPECT_GT(count, 50);
}

// What is seen directly is `emission`, one bounce is `direct`, the rest `indirect`.
TEST(PathSample, LayersAreWhatTheirNamesSay) {
  const Scene scene(room_with_lamp());
  PathIntegrator path, cut;
  cut.max_depth = 1;
  for_each_sample(camera({1, -3, 1.5f}, {0, 0, 1}, 70), SamplerKind::sobol,
                  [&](const Ray& ray, Sampler sampler) {
                    Sampler again = sampler;
                    std::array<Spectrum, 3> layers{black, black, black}, cut_layers{black, black, black};
                    path.radiance(scene, ray, sampler, layers);
                    cut.radiance(scene, ray, again, cut_layers);
                    EXPECT_EQ(layers[0], cut_layers[0]);
                    EXPECT_EQ(layers[1], cut_layers[1]);
                    EXPECT_EQ(cut_layers[2], black);
                  });
}

TEST(PathSample, ToldDepthIsANamedBias) {
  PathIntegrator path;
  EXPECT_TRUE(path.bias_notes().empty());
  path.max_depth = 3;
  ASSERT_EQ(path.bias_notes().size(), 1u);
  EXPECT_NE(path.bias_notes().front().find("3"), std::string::npos);
}

// Light that never leaves: within glass beyond the critical angle, and between perfect mirrors. Every path must end.
TEST(PathSample, TrappedPathsEnd) {
  const Lobes trapping[] = {Dielectric{1.5f}, Mirror{white}, Lambert{white}};
  for (const Lobes& lobe : trapping) {
    SceneDescription description;
    add_shape(description, sphere({0, 0, 0}, 1), add_material(description, lobe));
    description.environment.emplace();
    description.environment->prepare();
    const Scene scene(std::move(description));
    PathIntegrator path;
    for_each_sample(camera({0.9f, 0, 0}, {0.9f, 1, 0}, 60), SamplerKind::sobol,
                    [&](const Ray& ray, Sampler sampler) {
                      EXPECT_TRUE(is_finite(path.radiance(scene, ray, sampler, {})));
                    });
  }
}

}  // namespace
}  // namespace umbral::test
