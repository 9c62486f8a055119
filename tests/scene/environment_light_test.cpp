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

// ∫ pdf dω over each texel, where pdf sin θ is constant: two midpoints a side are exact but for the rounding.
TEST(Environment, HasADensityThatIntegratesToOneAndIsThatOfItsSamples) {
  for (const auto& [width, height, rotation] :
       {std::tuple{16, 8, 0.0f}, {7, 5, 77.0f}, {1, 1, 0.0f}, {32, 3, -400.0f}}) {
    const EnvironmentLight light = random_environment(width, height, rotation);
    constexpr int draws = 300'000;
    std::vector<double> expected, observed(static_cast<std::size_t>(width * height));
    double total = 0;
    for (int y = 0; y < height; ++y)
      for (int x = 0; x < width; ++x) {
        const Box2d texel{static_cast<double>(x) / width, (x + 1.0) / width, static_cast<double>(y) / height,
                          (y + 1.0) / height};
        const double mass = integral<3>(texel, [&](double u, double v) {
          return light.pdf(direction_of(u, v, rotation)) * 2 * pi_d * pi_d * std::sin(pi_d * v);
        });
        expected.push_back(draws * mass);
        total += mass;
      }
    EXPECT_NEAR(total, 1, 1e-5);
    Random random(2);
    int none = 0;
    for (int i = 0; i < draws; ++i) {
      const auto sample = light.sample(random.square());
      if (!sample) {
        ++none;
        continue;
      }
      const double azimuth = std::atan2(sample->wi.x, -sample->wi.z) / (2 * pi_d) + 0.5 + rotation / 360.0;
      const double polar = std::atan2(std::hypot(sample->wi.x, sample->wi.z), sample->wi.y);
      const auto x = static_cast<int>((azimuth - std::floor(azimuth)) * width);
      const auto y = std::clamp(static_cast<int>((1 - polar / pi_d) * height), 0, height - 1);
      ++observed[static_cast<std::size_t>(y * width + std::min(x, width - 1))];
      EXPECT_EQ(light.pdf(sample->wi), sample->pdf);
      EXPECT_EQ(light.emitted(sample->wi), sample->radiance);
      EXPECT_EQ(sample->distance, infinity);
      EXPECT_NEAR(glm::length(sample->wi), 1, 1e-6);
    }
    EXPECT_LT(none, 3);
    EXPECT_GT(chi_square(observed, expected).p, 1e-4) << width << " × " << height;
  }
}

// A bilinear look-up reaches half a texel beyond the texel itself: there must be no light that is never drawn, nor one
// whose weight runs away.
TEST(Environment, FindsTheWholeFluxOfOneBrightTexel) {
  double worst = 0;
  for (const auto& [bright_x, bright_y] : {std::pair{10, 8}, {0, 5}, {31, 12}, {7, 0}, {20, 15}}) {
    const EnvironmentLight light = environment_of(
        32, 16, [&](int x, int y) { return Spectrum(x == bright_x && y == bright_y ? 1e5f : 1e-3f); });
    double by_samples = 0, largest = 0;
    constexpr int grid = 512;
    for (int i = 0; i < grid * grid; ++i) {
      const auto sample = light.sample(
          {(static_cast<float>(i % grid) + 0.5f) / grid, (static_cast<float>(i / grid) + 0.5f) / grid});
      if (!sample) continue;
      const double weight = sample->radiance.g / sample->pdf;
      by_samples += weight / (grid * grid);
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
    EXPECT_LT(largest, 12 * expected) << "9 texels share what one has";
  }
  record({"Lights", "an environment of 1e-3 with one texel of 1e5 loses flux", "≤ 0.5 %",
          fmt::format("{:.2g} %", 100 * worst), "pbrt-v3 #62"});
}

// Near the poles the sine of the polar angle is small, and so must be its error.
TEST(Environment, KeepsItsDigitsAtThePoles) {
  for (const int height : {2, 64, 1024}) {
    const EnvironmentLight light = environment_of(4, height, [](int, int) { return Spectrum(1.0f); });
    const EnvironmentLight only_row = environment_of(4, 1, [](int, int) { return Spectrum(1.0f); });
    for (const double polar : {0.5, 0.1, 0.01, 1e-3, 1e-4, 1e-5})
      for (const double side : {1.0, -1.0}) {
        const Vec3 d(Vec3d(std::sin(polar) * 0.6, side * std::cos(polar), std::sin(polar) * 0.8));
        // One row, one colour: the density is 1/(2π² sin θ) all over.
        EXPECT_NEAR(only_row.pdf(d) * 2 * pi_d * pi_d * std::sin(polar), 1, 1e-5) << "polar angle " << polar;
        const double row_of_polar = std::floor(polar / pi_d * height);
        if (std::abs(polar / pi_d * height - std::round(polar / pi_d * height)) < 1e-3 * polar) continue;
        const Vec3 same_row(direction_of(0.3, 1 - (row_of_polar + 0.5) / height, 0));
        const double sine = std::sin(pi_d * (row_of_polar + 0.5) / height);
        const double expected = light.pdf(same_row) * sine / std::sin(polar);
        EXPECT_NEAR(light.pdf({d.x, std::abs(d.y), d.z}) / expected, 1, 1e-4) << height << ", " << polar;
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
