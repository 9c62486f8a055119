// The inside of a sphere whose albedo and emission vary: global illumination in closed form at every point.
#include "support/render_image.h"
#include "support/scene_kit.h"
#include "support/truth.h"
#include "support/ways.h"

namespace umbral::test {
namespace {

const TestImage albedo_image(16, 8, 0.1, 0.9, 1), emission_image(8, 8, 0, 2, 2);
const CameraSettings view = camera({0.35f, -0.2f, 0.15f}, {-0.6f, 1, 0.1f}, 95);

// (u, v) of the unit sphere's point p.
glm::dvec2 uv_of(const Vec3d& p) {
  const double turns = std::atan2(p.y, p.x) / (2 * pi_d);
  return {turns < 0 ? turns + 1 : turns, 1 - std::acos(glm::clamp(p.z, -1.0, 1.0)) / pi_d};
}

using OnSphere = std::function<Vec3d(const Vec3d&)>;

// By the midpoint rule in (z, φ), which are uniform on a sphere; edges of the checker below lie between its points.
Vec3d mean_over_sphere(const OnSphere& f) {
  constexpr int n = 1536;
  Vec3d sum(0);
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < n; ++j) {
      const double z = 2 * (i + 0.5) / n - 1, phi = 2 * pi_d * (j + 0.5) / n, r = std::sqrt(1 - z * z);
      sum += f({r * std::cos(phi), r * std::sin(phi), z});
    }
  return sum / (1.0 * n * n);
}

Vec3d albedo(const Vec3d& p) {
  const glm::dvec2 uv = uv_of(p);
  return albedo_image.at(uv.x, uv.y);
}

Vec3d emission(const Vec3d& p) {
  const glm::dvec2 uv = uv_of(p);
  return emission_image.at(uv.x, uv.y);
}

PixelImage image_of_sphere(const OnSphere& radiance, int cells) {
  return true_image(view, 16, cells,
                    [&](const DoubleRay& ray) { return radiance(on_sphere(ray, Vec3d(0), 1, true)); });
}

GateSettings with_quadrature_of_textures() {
  GateSettings settings;
  settings.resolution = 5e-5;
  return settings;
}

class SphereInteriorOracle : public testing::TestWithParam<Way> {};

// L(p) = Le(p) + ρ(p) ⟨Le⟩/(1 − ⟨ρ⟩).
TEST_P(SphereInteriorOracle, EmissionTexture) {
  SceneDescription description;
  description.camera = view;
  const MaterialId material = add_matte(description, add_texture(description, albedo_image.texture()));
  Shape& hull = add_shape(description, sphere({0, 0, 0}, 1), material);
  hull.emission.map = add_texture(description, emission_image.texture());
  hull.two_sided = true;
  const Scene scene(std::move(description));

  const Vec3d reflected = mean_over_sphere(emission) / (1.0 - mean_over_sphere(albedo));
  const PixelImage truth =
      image_of_sphere([&](const Vec3d& p) { return emission(p) + albedo(p) * reflected; }, 8);
  PathIntegrator path = GetParam().path();
  EXPECT_TRUE(agrees_with(truth, SmallRender{scene, path, GetParam().sampler, GetParam().spp(40, 56)},
                          with_quadrature_of_textures()));
}

INSTANTIATE_TEST_SUITE_P(Ways, SphereInteriorOracle, testing::ValuesIn(all_ways()),
                         [](const auto& tested) { return name_of(tested.param); });

class PointInSphereOracle : public testing::TestWithParam<SamplerKind> {};

const Vec3d light(-0.25, 0.3125, -0.375), intensity(1, 2, 3);

// E_d = I cos θ/d² at once; bounces add ⟨ρ E_d⟩/(1 − ⟨ρ⟩), the same everywhere.
PixelImage lit_by_point(const OnSphere& albedo_at, int cells) {
  const auto direct = [&](const Vec3d& p) {
    const Vec3d l = light - p;
    return intensity * (dot(l, -p) / std::pow(dot(l, l), 1.5));
  };
  const Vec3d bounced = mean_over_sphere([&](const Vec3d& p) { return albedo_at(p) * direct(p); }) /
                        (1.0 - mean_over_sphere(albedo_at));
  return image_of_sphere([&](const Vec3d& p) { return albedo_at(p) * (direct(p) + bounced) / pi_d; }, cells);
}

SceneDescription lit_sphere(TextureKinds albedo_texture) {
  SceneDescription description;
  description.camera = view;
  const TextureId texture = add_texture(description, std::move(albedo_texture));
  add_shape(description, sphere({0, 0, 0}, 1), add_matte(description, texture));
  description.lights.emplace_back(PointLight{Vec3(light), Spectrum(Vec3(intensity), 0)});
  return description;
}

TEST_P(PointInSphereOracle, ImageTexture) {
  const Scene scene(lit_sphere(albedo_image.texture()));
  PathIntegrator path;
  const int spp = GetParam() == SamplerKind::sobol ? 48 : 100;
  EXPECT_TRUE(agrees_with(lit_by_point(albedo, 8), SmallRender{scene, path, GetParam(), spp},
                          with_quadrature_of_textures()));
}

TEST_P(PointInSphereOracle, Checker) {
  CheckerTexture checker;
  checker.even = rgb(0.7f, 0.5f, 0.3f);
  checker.odd = rgb(0.3f, 0.4f, 0.6f);
  checker.uv_scale = {6, 3};
  checker.uv_offset = {0.25f, 0};
  const Scene scene(lit_sphere(checker));
  const auto albedo_at = [&](const Vec3d& p) {
    const glm::dvec2 uv = uv_of(p);
    const auto square = static_cast<int>(std::floor(6 * uv.x + 0.25) + std::floor(3 * uv.y));
    return Vec3d(Vec3(square % 2 == 0 ? checker.even : checker.odd));
  };
  GateSettings settings = with_quadrature_of_textures();
  settings.resolution = 5e-4;  // edges cross pixels
  PathIntegrator path;
  const int spp = GetParam() == SamplerKind::sobol ? 96 : 140;
  EXPECT_TRUE(agrees_with(lit_by_point(albedo_at, 64), SmallRender{scene, path, GetParam(), spp}, settings));
}

INSTANTIATE_TEST_SUITE_P(Samplers, PointInSphereOracle,
                         testing::Values(SamplerKind::sobol, SamplerKind::independent),
                         [](const auto& tested) {
                           return sampler_names()[static_cast<std::size_t>(tested.param)];
                         });

}  // namespace
}  // namespace umbral::test
