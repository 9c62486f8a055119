// Three oracles: a furnace, a light at the horizon, a picture of known texels.
#include "mutations/experiments.h"

#include <boost/math/distributions/beta.hpp>

#include "mutations/mutants.h"
#include "support/oracles.h"
#include "support/render_image.h"
#include "support/scene_kit.h"
#include "support/truth.h"

namespace umbral::test {
namespace {

constexpr int size = 16;

struct Oracle {
  std::string name;
  std::shared_ptr<const Scene> scene;
  PixelImage truth;
  int spp, max_depth;
};

// L = Le/(1 − ρ).
Oracle sphere_furnace() {
  const Vec3d albedo(0.2, 0.35, 0.5), emission(0.5, 1, 2);
  SceneDescription scene;
  scene.camera = camera({0.3f, 0.2f, -0.1f}, {1, 0.1f, 0.2f}, 80);
  add_shape(scene, sphere({0.1f, 0, 0.2f}, 1), add_matte(scene, Spectrum(Vec3(albedo), 0)),
            Spectrum(Vec3(emission), 0))
      .two_sided = true;
  return {"furnace",
          std::make_shared<Scene>(std::move(scene)),
          {size, size, std::vector<Vec3d>(size * size, emission / (1.0 - albedo))},
          32,
          0};
}

// A matte floor lit by a rectangle, half of which is below its horizon.
Oracle light_at_the_horizon() {
  const Vec3d albedo(0.3, 0.6, 0.9), radiance(2, 1, 0.5), up(0, 0, 1);
  const Vec3 origin{0.9f, -1.5f, -1}, across{0.3f, 3, 0}, upwards{0.2f, 0, 3};
  SceneDescription scene;
  scene.camera = camera({0, 0, 6}, {0, 0, 0}, 8, {0, 1, 0});
  add_shape(scene, rectangle({-0.48f, -0.48f, 0}, {0.96f, 0, 0}, {0, 0.96f, 0}),
            add_matte(scene, Spectrum(Vec3(albedo), 0)));
  add_shape(scene, rectangle(origin, upwards, across), add_matte(scene, black), Spectrum(Vec3(radiance), 0));
  const std::vector<Vec3d> corners{Vec3d(origin), Vec3d(origin + upwards), Vec3d(origin + upwards + across),
                                   Vec3d(origin + across)};
  const PixelImage truth = true_image(scene.camera, size, 4, [&](const DoubleRay& ray) {
    return albedo * radiance * polygon_form_factor(on_plane(ray, {0, 0, 0}, up), up, corners);
  });
  return {"light at the horizon", std::make_shared<Scene>(std::move(scene)), truth, 32, 1};
}

// A shining picture seen at a slant; its texels are placed `shift` of a texel to the side.
Oracle picture(float shift) {
  const TestImage texels(8, 8, 0.2, 2, 5);
  SceneDescription scene;
  scene.camera = camera({0.3f, -1, 2}, {0, 0, 0}, 35);
  ImageTexture texture = texels.texture();
  texture.uv_offset = {shift / 8, 0};
  Shape& canvas = add_shape(scene, rectangle({-2, -2, 0}, {4, 0, 0}, {0, 4, 0}), add_matte(scene, black));
  canvas.emission.map = add_texture(scene, texture);
  const PixelImage truth = true_image(scene.camera, size, 8, [&](const DoubleRay& ray) {
    const Vec3d p = on_plane(ray, {0, 0, 0}, {0, 0, 1});
    return texels.at((p.x + 2) / 4, (p.y + 2) / 4);
  });
  return {"picture", std::make_shared<Scene>(std::move(scene)), truth, 64, 1};
}

using MakeIntegrator = std::unique_ptr<Integrator> (*)(int max_depth, int roulette_depth);

Experiment experiment(const std::string& mutation, const Oracle& oracle, MakeIntegrator make) {
  std::shared_ptr<Integrator> integrator = make(oracle.max_depth, 1);
  integrator->prepare(*oracle.scene);
  return {mutation, oracle.name, oracle.scene, oracle.truth, std::move(integrator), oracle.spp};
}

}  // namespace

Judgement Experiment::decide(int run) const {
  GateSettings settings;
  settings.resolution = 5e-5;  // of the truth's quadrature
  const SmallRender render{*scene, *integrator, SamplerKind::sobol, spp, size};
  return settled_against(truth, render, settings, 1'000'000 + 10'000 * static_cast<std::uint64_t>(run));
}

// With a quarter of the gate's own samples: what is caught so is caught with all of them, and a run is a second.
std::vector<Experiment> mutations() {
  const auto hurried = [](Oracle oracle) {
    oracle.spp /= 4;
    return oracle;
  };
  const Oracle furnace = hurried(sphere_furnace()), light = hurried(light_at_the_horizon());
  return {experiment("albedo × 0.99", furnace, make_albedo),
          experiment("cosine missing", light, make_cosine_missing),
          experiment("roulette without 1/q", furnace, make_roulette_unweighted),
          experiment("MIS weight dropped", light, make_mis_weight_dropped),
          experiment("half-texel shift", hurried(picture(0.5f)), make_unchanged),
          experiment("wrong Jacobian of a density", light, make_wrong_jacobian),
          experiment("cosine clamped at 0.1", light, make_clamped_cosine),
          experiment("light density × 1.01", light, make_light_pdf)};
}

std::vector<Experiment> null_experiments() {
  return {experiment("", sphere_furnace(), make_unchanged),
          experiment("", light_at_the_horizon(), make_unchanged), experiment("", picture(0), make_unchanged)};
}

double clopper_pearson_lower(int k, int n) {
  return k == 0 ? 0 : boost::math::quantile(boost::math::beta_distribution<>(k, n - k + 1.0), 0.05);
}

double clopper_pearson_upper(int k, int n) {
  return k == n ? 1 : boost::math::quantile(boost::math::beta_distribution<>(k + 1.0, n - k), 0.95);
}

}  // namespace umbral::test
