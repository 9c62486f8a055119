// Point, spot and distant lights on matte surfaces: formulas at every pixel.
#include "support/render_image.h"
#include "support/scene_kit.h"
#include "support/truth.h"
#include "support/ways.h"

namespace umbral::test {
namespace {

const Vec3d albedo(0.2, 0.5, 0.8), strength(3, 2, 1);
const CameraSettings view = camera({0.5f, -2, 3}, {0.1f, 0.2f, 0}, 40);

SceneDescription floor_under(const LightKinds& light) {
  SceneDescription scene;
  scene.camera = view;
  add_shape(scene, rectangle({-9, -9, 0}, {18, 0, 0}, {0, 18, 0}),
            add_matte(scene, Spectrum(Vec3(albedo), 0)));
  scene.lights.push_back(light);
  return scene;
}

// `irradiance` of the floor at p.
template <class Irradiance>
PixelImage floor_image(const Irradiance& irradiance) {
  return true_image(view, 16, 4, [&](const DoubleRay& ray) {
    return albedo / pi_d * irradiance(on_plane(ray, {0, 0, 0}, {0, 0, 1}));
  });
}

class DeltaLightOracle : public testing::TestWithParam<Way> {
 protected:
  testing::AssertionResult floor_agrees(const LightKinds& light, const PixelImage& truth) {
    const Scene scene(floor_under(light));
    PathIntegrator path = GetParam().path();
    return agrees_with(truth, SmallRender{scene, path, GetParam().sampler, GetParam().spp(32, 96)});
  }
};

TEST_P(DeltaLightOracle, Point) {
  const Vec3d light(-0.4, 0.6, 1.3);
  EXPECT_TRUE(
      floor_agrees(PointLight{Vec3(light), Spectrum(Vec3(strength), 0)}, floor_image([&](const Vec3d& p) {
                     const Vec3d l = light - p;
                     return strength * l.z / std::pow(dot(l, l), 1.5);
                   })));
}

// All in the soft edge of the cone.
TEST_P(DeltaLightOracle, Spot) {
  const Vec3d light(-0.4, 0.6, 1.5), target(0.1, 0.1, 0);
  const SpotLight spot{Vec3(light), Vec3(target), Spectrum(Vec3(strength), 0), 75, 70};
  EXPECT_TRUE(floor_agrees(spot, floor_image([&](const Vec3d& p) {
                             const Vec3d l = light - p;
                             const Vec3d axis = glm::normalize(target - light);
                             const double degrees = std::acos(-dot(glm::normalize(l), axis)) * 180 / pi_d;
                             const double t = glm::clamp((75 - degrees) / 70, 0.0, 1.0);
                             return strength * (t * t * (3 - 2 * t) * l.z / std::pow(dot(l, l), 1.5));
                           })));
}

TEST_P(DeltaLightOracle, Distant) {
  const Vec3d direction(0.5, -0.3, -0.8);
  EXPECT_TRUE(
      floor_agrees(DistantLight{Vec3(direction), Spectrum(Vec3(strength), 0)},
                   floor_image([&](const Vec3d&) { return strength * -glm::normalize(direction).z; })));
}

// A sphere lit from where it is seen: the mean over its disk is (2/3) ρE/π. From 10⁵ radii away
// the disk differs from that of parallel rays by less than a part in 10⁵.
TEST_P(DeltaLightOracle, FullMoon) {
  SceneDescription description;
  const double distance = 1e5, half_width = 1.25;
  description.camera =
      camera({0, -1e5f, 0}, {0, 0, 0}, static_cast<float>(2 * std::atan(half_width / distance) * 180 / pi_d));
  add_shape(description, sphere({0, 0, 0}, 1), add_matte(description, Spectrum(Vec3(albedo), 0)));
  description.lights.emplace_back(DistantLight{{0, 1, 0}, Spectrum(Vec3(strength), 0)});
  const Scene scene(std::move(description));
  const Vec3d disk_mean = 2.0 / 3 * albedo * strength / pi_d;
  const Vec3d image_mean = disk_mean * (pi_d / sqr(2 * half_width));
  PathIntegrator path = GetParam().path();
  GateSettings settings;
  settings.tiles = 1;
  EXPECT_TRUE(agrees_with({16, 16, std::vector<Vec3d>(256, image_mean)},
                          SmallRender{scene, path, GetParam().sampler, GetParam().spp(32, 96)}, settings));
}

// Lights without size are found the same way by every strategy.
INSTANTIATE_TEST_SUITE_P(Ways, DeltaLightOracle,
                         testing::Values(Way{Strategy::mis, SamplerKind::sobol},
                                         Way{Strategy::bsdf, SamplerKind::independent}),
                         [](const auto& tested) { return name_of(tested.param); });

}  // namespace
}  // namespace umbral::test
