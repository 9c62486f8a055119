// Sun and sky: the model's own figures, the whole flux of the sun's disk, and what is below the horizon.
#include "scene/lights/sky.h"

#include <gtest/gtest.h>

#include "support/quadrature.h"

namespace umbral {
namespace {

using namespace test;

SkyLight sky(float elevation_degrees, float turbidity, bool sun) {
  SkyLight light;
  const double elevation = glm::radians(static_cast<double>(elevation_degrees));
  light.sun_direction =
      Vec3(Vec3d(0.6 * std::cos(elevation), std::sin(elevation), 0.8 * std::cos(elevation)));
  light.turbidity = turbidity;
  light.sun = sun;
  light.scale = 1;
  return light;
}

// Luminance of the zenith, 4.0453 T − 4.9710 times tan χ and so on, worked out by hand for T = 3.
TEST(Sky, HasTheZenithOfTheModel) {
  const SkyLight noon = sky(60, 3, false);
  const double theta = pi_d / 6, chi = (4.0 / 9 - 3 / 120.0) * (pi_d - 2 * theta);
  const double kilocandela = (4.0453 * 3 - 4.9710) * std::tan(chi) - 0.2155 * 3 + 2.4192;
  EXPECT_NEAR(kilocandela, 10.4, 0.3) << "a clear sky has some thousand candela";
  EXPECT_NEAR(luminance(noon.sky_radiance({0, 1, 0})) * 179 / 1000, kilocandela, 0.01 * kilocandela);
}

TEST(Sky, IsBlueAwayFromTheSunAndBrightAroundIt) {
  const SkyLight light = sky(40, 2.5f, false);
  const Vec3d sun = glm::normalize(Vec3d(light.sun_direction));
  const Spectrum away = light.sky_radiance(glm::normalize(Vec3d(-sun.x, sun.y, -sun.z)));
  const Spectrum around = light.sky_radiance(sun);
  EXPECT_GT(away.b, 1.5f * away.r);
  EXPECT_GT(luminance(around), 3 * luminance(away));
}

TEST(Sky, SunIsRedderAndDimmerWhenItIsLow) {
  const Spectrum noon = sky(80, 3, true).sun_irradiance(), evening = sky(6, 3, true).sun_irradiance();
  EXPECT_LT(luminance(evening), 0.4f * luminance(noon));
  EXPECT_GT(evening.r / evening.b, 2 * noon.r / noon.b);
  EXPECT_NEAR(luminance(noon), 550, 120) << "about 100 klx by 179 lm/W";
}

// What the image sends down is the sky's own integral and the sun's irradiance, by the light's samples.
TEST(Sky, ImageHoldsTheFluxOfSkyAndSun) {
  const SkyLight light = sky(35, 4, true);
  const EnvironmentLight image = light.environment();
  double sampled = 0;
  constexpr int grid = 512;
  for (int i = 0; i < grid * grid; ++i) {
    const auto sample = image.sample(
        {(static_cast<float>(i % grid) + 0.5f) / grid, (static_cast<float>(i / grid) + 0.5f) / grid});
    if (sample) sampled += std::max(0.0f, sample->wi.y) * sample->radiance.g / sample->pdf / (grid * grid);
  }
  double expected = light.sun_irradiance().g * glm::normalize(light.sun_direction).y;
  for (int part = 0; part < 16; ++part)
    expected += integral<16>(Box2d{part / 16.0, (part + 1) / 16.0, 0, 1}, [&](double u, double v) {
      const double z = v, r = std::sqrt(1 - z * z), phi = 2 * pi_d * u;
      return 2 * pi_d * z * light.sky_radiance({r * std::cos(phi), z, r * std::sin(phi)}).g;
    });
  EXPECT_NEAR(sampled / expected, 1, 0.01);
  EXPECT_NEAR(image.emitted({0, -1, 0}).g, 0.2 * expected / pi_d, 0.02 * expected / pi_d)
      << "the ground's answer";
}

}  // namespace
}  // namespace umbral
