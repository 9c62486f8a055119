// The environment as a light: irradiance in closed form, orientation, and one bright texel.
#include "support/render_image.h"
#include "support/scene_kit.h"
#include "support/truth.h"
#include "support/ways.h"

namespace umbral::test {
namespace {

const Vec3d albedo(0.9, 0.6, 0.3);

// The direction that the point (u, v) of an environment image shows, as documented: +y up at v = 1, −z in the
// middle column, +x to the right of it.
Vec3d direction_of(double u, double v) {
  const double theta = pi_d * (1 - v), azimuth = 2 * pi_d * (u - 0.5);
  return {std::sin(theta) * std::sin(azimuth), std::cos(theta), -std::sin(theta) * std::cos(azimuth)};
}

SceneDescription lit_by(const TestImage& image, float rotation) {
  SceneDescription scene;
  scene.environment.emplace();
  scene.environment->image = image.texture_image();
  scene.environment->rotation = rotation;
  scene.environment->prepare();
  return scene;
}

// Counter-clockwise as seen from above, about +y.
Vec3d turned(const Vec3d& d, double degrees) {
  const double a = degrees * pi_d / 180;
  return {std::cos(a) * d.x + std::sin(a) * d.z, d.y, std::cos(a) * d.z - std::sin(a) * d.x};
}

class EnvironmentOracle : public testing::TestWithParam<Way> {};

// L(ω) = 1 + 0.9 ω·a shines π + 0.9 (2π/3) n·a on a surface with normal n: seen on all normals of a sphere.
TEST_P(EnvironmentOracle, LinearInDirection) {
  const Vec3d axes[] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};  // one a channel
  const TestImage image(512, 256, [&](double u, double v) {
    const Vec3d d = direction_of(u, v);
    return Vec3d(1) + 0.9 * Vec3d(dot(d, axes[0]), dot(d, axes[1]), dot(d, axes[2]));
  });
  constexpr float rotation = 70;
  SceneDescription description = lit_by(image, rotation);
  description.camera = camera({0.8f, 0.7f, 0.9f}, {0, 0, 0}, 45, {0, 1, 0});
  add_shape(description, sphere({0, 0, 0}, 1), add_matte(description, Spectrum(Vec3(albedo), 0)));
  const Scene scene(std::move(description));
  const PixelImage truth = true_image(scene.camera(), 16, 4, [&](const DoubleRay& ray) {
    const Vec3d n = on_sphere(ray, Vec3d(0), 1, false);
    const auto along = [&](const Vec3d& axis) { return dot(n, turned(axis, rotation)); };
    return albedo * (Vec3d(1) + 0.6 * Vec3d(along(axes[0]), along(axes[1]), along(axes[2])));
  });
  PathIntegrator path = GetParam().path();
  GateSettings settings;
  settings.resolution = 1e-4;  // of the image
  EXPECT_TRUE(agrees_with(truth,
                          SmallRender{scene, path, GetParam().sampler,
                                      GetParam().spp(64, GetParam().strategy == Strategy::light ? 640 : 128)},
                          settings));
}

INSTANTIATE_TEST_SUITE_P(Ways, EnvironmentOracle, testing::ValuesIn(all_ways()),
                         [](const auto& tested) { return name_of(tested.param); });

class BrightTexelOracle : public testing::TestWithParam<Way> {};

// One texel 10⁵ times as bright as the others, on a floor with y up. Bilinear look-up spreads it over four cells.
TEST_P(BrightTexelOracle, OnAFloor) {
  TestImage image(32, 16, [](double, double) { return Vec3d(0.02); });
  image.texel(19, 11) = Vec3d(2000, 1000, 500);
  SceneDescription description = lit_by(image, 0);
  description.camera = camera({0, 2, 0}, {0, 0, 0}, 40, {0, 0, -1});
  add_shape(description, rectangle({-9, 0, -9}, {0, 0, 18}, {18, 0, 0}),
            add_matte(description, Spectrum(Vec3(albedo), 0)));
  const Scene scene(std::move(description));

  Vec3d irradiance(0);  // ∫ L cos θ dω over the upper half, by the midpoint rule in (u, v)
  constexpr int n = 2048;
  for (int j = n / 2; j < n; ++j)
    for (int i = 0; i < n; ++i) {
      const double u = (i + 0.5) / n, v = (j + 0.5) / n, theta = pi_d * (1 - v);
      irradiance += image.at(u, std::min(v, 1 - 0.5 / 16)) * (std::cos(theta) * std::sin(theta));
    }
  irradiance *= 2 * pi_d * pi_d / (1.0 * n * n);
  PathIntegrator path = GetParam().path();
  EXPECT_TRUE(agrees_with({16, 16, std::vector<Vec3d>(256, albedo / pi_d * irradiance)},
                          SmallRender{scene, path, GetParam().sampler, GetParam().spp(96, 1280)}));
}

// The surface's own directions find so small a light too rarely.
INSTANTIATE_TEST_SUITE_P(Ways, BrightTexelOracle,
                         testing::Values(Way{Strategy::mis, SamplerKind::sobol},
                                         Way{Strategy::mis, SamplerKind::independent},
                                         Way{Strategy::light, SamplerKind::sobol}),
                         [](const auto& tested) { return name_of(tested.param); });

}  // namespace
}  // namespace umbral::test
