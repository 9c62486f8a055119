// Coloured glass: what a path loses inside of closed bodies, in closed form.
#include <gtest/gtest.h>

#include "bsdf/interfaces/fresnel.h"
#include "integrators/path.h"
#include "support/scene_kit.h"

namespace umbral::test {
namespace {

const Spectrum tint = rgb(0.9f, 0.5f, 0.01f);
constexpr float tint_distance = 0.7f, thickness = 1.3f;

// exp(−σ d) of that tint.
double left_after(int channel, double way) {
  return std::pow(static_cast<double>(tint[channel]), way / tint_distance);
}

Dielectric stained(float eta) {
  Dielectric glass{eta};
  glass.attenuation_color = tint;
  glass.attenuation_distance = tint_distance;
  return glass;
}

// A slab across the z axis, and white light all around.
SceneDescription slab(const Lobes& lobe) {
  SceneDescription scene;
  add_shape(scene, box({-8, -8, 0}, {8, 8, thickness}), add_material(scene, lobe));
  scene.environment.emplace();
  scene.environment->radiance = white;
  scene.environment->prepare();
  return scene;
}

Spectrum mean_radiance(const Scene& scene, const Ray& ray, std::uint32_t samples) {
  PathIntegrator path;
  Spectrum sum = black;
  for (std::uint32_t i = 0; i < samples; ++i) {
    Sampler sampler(SamplerKind::sobol, {3, 0, 0, 0, i});
    sum += path.radiance(scene, ray, sampler, {});
  }
  return sum / static_cast<float>(samples);
}

TEST(Absorption, OfASlabWithoutInterfaceIsBeersLaw) {
  Principled principled;
  principled.transmission = 1;
  principled.roughness = 0;
  principled.ior = 1;
  principled.attenuation_color = tint;
  principled.attenuation_distance = tint_distance;
  for (const Lobes& lobe : {Lobes{stained(1)}, Lobes{principled}}) {
    const Scene scene(slab(lobe));
    for (const double c : {1.0, 0.6, 0.3}) {
      const Vec3 d(static_cast<float>(std::sqrt(1 - c * c)), 0, static_cast<float>(c));
      const Ray ray{{0, 0, -1}, d};
      const Spectrum seen = mean_radiance(scene, ray, 1);
      // From the face that was met to where the ray leaves that started beside it, by its offset along the normal.
      const std::optional<Hit> hit = scene.intersect(ray);
      ASSERT_TRUE(hit);
      const double offset = static_cast<double>(scene.surface(ray, *hit).origin_towards(d).z);
      ASSERT_TRUE(offset > 0 && offset < 1e-4);
      const double way = (thickness - offset) / c + offset * c;
      for (int channel = 0; channel < 3; ++channel)
        EXPECT_NEAR(seen[channel], left_after(channel, way), 1e-6) << "cos " << c;
    }
  }
}

// Along the normal, with a = exp(−σ d) and all that goes to and fro between the faces: R + (1 − R)² a/(1 − R a).
TEST(Absorption, OfASlabOfGlassCountsEveryPassage) {
  const Scene scene(slab(stained(1.8f)));
  const Spectrum seen = mean_radiance(scene, {{0, 0, -1}, {0, 0, 1}}, 1 << 14);
  const double r = fresnel_dielectric(1, 1.8f);
  for (int channel = 0; channel < 3; ++channel) {
    const double a = left_after(channel, thickness);
    EXPECT_NEAR(seen[channel], r + sqr(1 - r) * a / (1 - r * a), 2e-3)
        << channel;  // deviation of one: below 0.3
  }
}

// A lamp and a matte floor inside of the slab: the light asked for directly goes through the glass too.
TEST(Absorption, TakesFromDirectLightInside) {
  SceneDescription description;
  add_shape(description, box({-9, -9, 0}, {9, 9, 6}), add_material(description, stained(1)));
  add_shape(description, rectangle({-5, -5, 2}, {0, 10, 0}, {10, 0, 0}), add_matte(description, grey(0.6f)));
  description.lights.emplace_back(PointLight{{0.5f, 0, 1}, white});
  const Scene scene(std::move(description));
  PathIntegrator path;
  path.max_depth = 3;
  Sampler sampler(SamplerKind::sobol, {3, 0, 0, 0, 0});
  const Spectrum seen = path.radiance(scene, {{0, 0, -1}, {0, 0, 1}}, sampler, {});
  const double way = std::sqrt(1.25), irradiance = (1 / way) / sqr(way);
  for (int channel = 0; channel < 3; ++channel)
    EXPECT_NEAR(seen[channel], 0.6 / pi_d * irradiance * left_after(channel, 2 + way), 1e-6);
}

TEST(Absorption, HasAnEndToItsColours) {
  EXPECT_FALSE(Absorption::of_color(tint, infinity).absorbs());
  EXPECT_FALSE(Absorption::of_color(white, 1).absorbs());
  const Absorption opaque = Absorption::of_color(black, 1);
  EXPECT_EQ(opaque.transmittance(0), white);
  EXPECT_LT(max_component(opaque.transmittance(1)), 1e-29);
  EXPECT_EQ(opaque.transmittance(infinity), black);
  EXPECT_EQ(Absorption{}.transmittance(infinity), white);
}

}  // namespace
}  // namespace umbral::test
