// The environment: orientation, densities that integrate to 1 and are those of the samples, bright texels, poles.
#include "scene/lights/environment.h"

#include <gtest/gtest.h>

#include "support/chi_square.h"
#include "support/quadrature.h"
#include "support/random.h"
#include "support/stability.h"

namespace umbral {
namespace {

using namespace test;

// `value(x, y)` of the texel, row 0 at the bottom.
template <class Value>
EnvironmentLight environment_of(int width, int height, Value&& value, float rotation = 0) {
  TexelGrid<Float4> grid(width, height);
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) grid.set(x, y, value(x, y));
  EnvironmentLight light;
  light.image = std::make_shared<TextureImage>(TextureImage::Texels(std::move(grid)));
  light.rotation = rotation;
  light.prepare();
  return light;
}

EnvironmentLight constant_environment(const Spectrum& radiance) {
  EnvironmentLight light;
  light.radiance = radiance;
  light.prepare();
  return light;
}

EnvironmentLight random_environment(int width, int height, float rotation) {
  Random random(static_cast<std::uint64_t>(width));
  return environment_of(
      width, height,
      [&](int, int) {
        const double x = random.log_between(1e-3, 1e3);
        return Spectrum(x, 0.5 * x, 0.1 * x, 1);
      },
      rotation);
}

// The direction seen at these coordinates of the image: u to the right, 0.5 at −z; v up from −y to +y.
Vec3 direction_of(double u, double v, double rotation) {
  const double azimuth = 2 * pi_d * (u - 0.5) - glm::radians(rotation), polar = pi_d * (1 - v);
  return Vec3(
      Vec3d(std::sin(polar) * std::sin(azimuth), std::cos(polar), -std::sin(polar) * std::cos(azimuth)));
}

TEST(Environment, ShowsTheImageUprightWithItsMiddleAtMinusZ) {
  // 8 columns: red rises to the right; 4 rows: green rises upwards.
  const EnvironmentLight light =
      environment_of(8, 4, [](int x, int y) { return Spectrum(x + 0.5, y + 0.5, 1, 1); });
  EXPECT_NEAR(light.emitted({0, 0, -1}).r, 4, 1e-4) << "between the columns 3 and 4";
  EXPECT_NEAR(light.emitted({1, 0, 0}).r, 6, 1e-4) << "right of it";
  EXPECT_NEAR(light.emitted({-1, 0, 0}).r, 2, 1e-4);
  EXPECT_NEAR(light.emitted({0, 1, 0}).g, 3.5, 1e-4) << "the top row, not blended with the bottom one";
  EXPECT_NEAR(light.emitted({0, -1, 0}).g, 0.5, 1e-4);
  EXPECT_NEAR(light.emitted({0, 0, -1}).g, 2, 1e-4);
}

TEST(Environment, TurnsCounterClockwiseSeenFromAbove) {
  const auto red = [](int x, int y) { return Spectrum(x + 0.5, y + 0.5, 1, 1); };
  const EnvironmentLight plain = environment_of(16, 8, red), turned = environment_of(16, 8, red, 30);
  // What was seen at −z is seen 30° counter-clockwise of it, towards −x.
  const double a = glm::radians(30.0);
  EXPECT_NEAR(turned.emitted(Vec3(Vec3d(-std::sin(a), 0, -std::cos(a)))).r, plain.emitted({0, 0, -1}).r,
              1e-3);
  Random random(1);
  for (int i = 0; i < 1000; ++i) {
    const Vec3d d = random.direction();
    const Vec3d back(std::cos(a) * d.x - std::sin(a) * d.z, d.y, std::sin(a) * d.x + std::cos(a) * d.z);
    const double difference = turned.emitted(Vec3(d)).r - plain.emitted(Vec3(back)).r;
    EXPECT_LT(std::min(std::abs(difference), std::abs(std::abs(difference) - 16)), 2e-3);
  }
}

TEST(Environment, MultipliesTheImageByItsRadiance) {
  EnvironmentLight light = environment_of(2, 1, [](int, int) { return Spectrum(2, 3, 4, 0.5f); });
  light.radiance = rgb(10, 1, 0.5f);
  light.prepare();
  EXPECT_EQ(light.emitted({0, 0, -1}), rgb(20, 3, 2)) << "alpha is no light";
  const EnvironmentLight constant = constant_environment(rgb(1, 2, 3));
  EXPECT_EQ(constant.emitted({0.6f, 0.8f, 0}), rgb(1, 2, 3));
}

TEST(Environment, ExposureIsInStops) {
  EnvironmentLight light = environment_of(2, 1, [](int, int) { return Spectrum(2, 3, 4, 1); });
  light.exposure = -2;
  light.prepare();
  EXPECT_EQ(light.emitted({0, 0, -1}), rgb(0.5f, 0.75f, 1));
  EXPECT_EQ(light.sample({0.4f, 0.4f})->radiance, rgb(0.5f, 0.75f, 1));
  EnvironmentLight constant;
  constant.radiance = grey(3);
  constant.exposure = 1;
  constant.prepare();
  EXPECT_EQ(constant.emitted({0, 1, 0}), grey(6));
  EXPECT_EQ(constant.sample({0.3f, 0.4f})->radiance, grey(6));
  EXPECT_NEAR(constant.power(2) / (4 * pi_d * pi_d * 4 * 6), 1, 1e-6);
}

TEST(Environment, OfOneColourIsSampledEvenly) {
  const EnvironmentLight light = constant_environment(rgb(1, 2, 3));
  double z = 0, z2 = 0;
  constexpr int grid = 100;
  for (int i = 0; i < grid * grid; ++i) {
    const auto sample = light.sample(
        {(static_cast<float>(i % grid) + 0.5f) / grid, (static_cast<float>(i / grid) + 0.5f) / grid});
    ASSERT_TRUE(sample);
    EXPECT_NEAR(sample->pdf, 1 / (4 * pi_d), 1e-8);
    EXPECT_EQ(light.pdf(sample->wi), sample->pdf);
    z += sample->wi.y;
    z2 += sqr(sample->wi.y);
  }
  EXPECT_NEAR(z / (grid * grid), 0, 1e-3);
  EXPECT_NEAR(z2 / (grid * grid), 1.0 / 3, 1e-3);
}

TEST(Environment, SamplesTellTheirDensityAndRadiance) {
  for (const float rotation : {0.0f, 77.0f, -400.0f}) {
    const EnvironmentLight light = random_environment(7, 5, rotation);
    Random random(2);
    for (int i = 0; i < 10'000; ++i) {
      const auto sample = light.sample(random.square());
      ASSERT_TRUE(sample);
      EXPECT_EQ(light.pdf(sample->wi), sample->pdf);
      EXPECT_EQ(light.emitted(sample->wi), sample->radiance);
      EXPECT_EQ(sample->distance, infinity);
      EXPECT_NEAR(glm::length(sample->wi), 1, 1e-6);
    }
  }
}

// Readers of other formats give the whole way from the world to the image, here one that mirrors: what is sampled is what
// is seen, and the flux stays.
TEST(Environment, MayLieAnyWay) {
  EnvironmentLight plain = random_environment(16, 8, 0), turned = plain;
  Mat3 way = glm::transpose(Mat3(Vec3(0, 0.6f, 0.8f), Vec3(1, 0, 0), Vec3(0, 0.8f, -0.6f)));
  turned.image_from_world = way;
  turned.prepare();
  Random random(3);
  for (int i = 0; i < 1000; ++i) {
    const Vec3 d(random.direction());
    EXPECT_NEAR(turned.emitted(d).r / plain.emitted(way * d).r, 1, 1e-5);
    EXPECT_NEAR(turned.pdf(d) / plain.pdf(way * d), 1, 1e-5);
    const auto sample = turned.sample(random.square());
    ASSERT_TRUE(sample);
    EXPECT_EQ(turned.emitted(sample->wi), sample->radiance);
  }
  EXPECT_EQ(turned.power(1), plain.power(1));
}

// A sun in one texel: all samples that it gets weigh nearly the same, so that it converges as a lamp does. At the poles
// themselves the sine changes within the texel, and weights by up to three.
TEST(Environment, FindsTheWholeFluxOfOneBrightTexel) {
  double worst = 0;
  for (const auto& [bright_x, bright_y] : {std::pair{10, 8}, {0, 5}, {31, 12}, {7, 0}, {20, 15}}) {
    const EnvironmentLight light = environment_of(
        32, 16, [&](int x, int y) { return Spectrum(x == bright_x && y == bright_y ? 1e6f : 1e-3f); });
    double by_samples = 0, squares = 0, largest = 0;
    constexpr int grid = 512;
    for (int i = 0; i < grid * grid; ++i) {
      const auto sample = light.sample(
          {(static_cast<float>(i % grid) + 0.5f) / grid, (static_cast<float>(i / grid) + 0.5f) / grid});
      if (!sample) continue;
      const double weight = sample->radiance.g / sample->pdf;
      by_samples += weight / (grid * grid);
      squares += weight * weight / (grid * grid);
      largest = std::max(largest, weight);
    }
    // ∫ L dω over the half texels, within which the look-up is smooth.
    double expected = 0;
    for (int y = 0; y < 32; ++y)
      for (int x = 0; x < 64; ++x)
        expected +=
            integral<4>(Box2d{x / 64.0, (x + 1) / 64.0, y / 32.0, (y + 1) / 32.0}, [&](double u, double v) {
              return light.emitted(direction_of(u, v, 0)).g * 2 * pi_d * pi_d * std::sin(pi_d * v);
            });
    EXPECT_NEAR(by_samples / expected, 1, 5e-3) << bright_x << ", " << bright_y;
    worst = std::max(worst, std::abs(by_samples / expected - 1));
    const bool at_pole = bright_y == 0 || bright_y == 15;
    EXPECT_LT(largest, (at_pole ? 3.2 : 1.25) * expected);
    EXPECT_LT(squares / sqr(by_samples) - 1, at_pole ? 0.5 : 0.01) << "relative variance of one sample";
  }
  record({"Lights", "an environment of 1e-3 with one texel of 1e6 loses flux", "≤ 0.5 %",
          fmt::format("{:.2g} %", 100 * worst), "pbrt-v3 #62"});
}

// Near the poles the sine of the polar angle is small, and so must be its error. Of one colour, the density times that
// sine is the sine at the middles of the rows, interpolated; probabilities of rows are multiples of 2⁻²⁴.
TEST(Environment, KeepsItsDigitsAtThePoles) {
  for (const int height : {1, 2, 64, 1024}) {
    const EnvironmentLight light = environment_of(4, height, [](int, int) { return Spectrum(1.0f); });
    const auto sine = [&](double row) {
      return std::sin(pi_d * (std::clamp(row, 0.0, height - 1.0) + 0.5) / height);
    };
    double mean = 0;
    for (int row = 0; row < height; ++row) mean += sine(row) / height;
    for (const double polar : {0.5, 0.1, 0.01, 1e-3, 1e-4, 1e-5})
      for (const double side : {1.0, -1.0}) {
        const Vec3 d(Vec3d(std::sin(polar) * 0.6, side * std::cos(polar), std::sin(polar) * 0.8));
        const double row = polar / pi_d * height - 0.5, low = std::floor(row);
        const double expected = std::lerp(sine(low), sine(low + 1), row - low) / mean;
        const double step = 0x1p-24 * height / expected;
        EXPECT_NEAR(light.pdf(d) * 2 * pi_d * pi_d * std::sin(polar) / expected, 1, 1e-4 + step)
            << height << ", " << polar;
      }
  }
}

TEST(Environment, BearsDirectionsAtThePolesThemselves) {
  const EnvironmentLight light = random_environment(16, 8, 10);
  for (const Vec3& d : {Vec3(0, 1, 0), Vec3(0, -1, 0), Vec3(1e-30f, 1, 0), Vec3(0, -1, 1e-20f)}) {
    EXPECT_TRUE(is_finite(light.emitted(d)));
    EXPECT_TRUE(std::isfinite(light.pdf(d)) && light.pdf(d) >= 0);
  }
  for (const float x : {0.0f, 0x1p-32f, 0.5f, one_minus_epsilon})
    for (const float y : {0.0f, 0x1p-32f, 0.5f, one_minus_epsilon})
      if (const auto sample = light.sample({x, y})) {
        EXPECT_TRUE(std::isfinite(sample->pdf) && sample->pdf > 0);
        EXPECT_TRUE(is_finite(sample->radiance));
      }
}

TEST(Environment, HasThePowerThatPassesItsScene) {
  const EnvironmentLight constant = constant_environment(white);
  // 4π L through a disk of the scene's radius, from every side.
  EXPECT_NEAR(constant.power(3), 4 * pi_d * pi_d * 9, 1e-3);
  const EnvironmentLight image = environment_of(64, 32, [](int, int) { return Spectrum(2.0f); });
  EXPECT_NEAR(image.power(3) / (2 * constant.power(3)), 1, 1e-5);
}

TEST(Environment, ThatIsBlackIsNeverDrawnWithLight) {
  const EnvironmentLight light = environment_of(4, 2, [](int, int) { return Spectrum(0.0f); });
  const auto sample = light.sample({0.3f, 0.6f});
  EXPECT_TRUE(!sample || is_black(sample->radiance));
  EXPECT_EQ(light.power(1), 0);
}

}  // namespace
}  // namespace umbral
