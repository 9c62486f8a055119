// Images that spot lights throw: which texel shines where, and how much in all.
#include <gtest/gtest.h>

#include "scene/lights/spot.h"
#include "support/random.h"

namespace umbral {
namespace {

using test::Random;

// 4 × 2 texels, each with a colour of its own; (0, 0) is at the lower left.
float value_at(int x, int y) { return static_cast<float>(1 + x + 4 * y); }

std::shared_ptr<const TextureImage> image_of(int width, int height, const auto& value) {
  TexelGrid<Float4> grid(width, height);
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) grid.set(x, y, Spectrum(Vec3(static_cast<float>(value(x, y))), 1));
  return std::make_shared<TextureImage>(TextureImage::Texels(std::move(grid)));
}

// Hangs at (1, 2, 3) and shines along −y, its image's upper edge towards −z and so its right edge towards +x.
SpotLight projector(std::shared_ptr<const TextureImage> image) {
  SpotLight spot;
  spot.position = {1, 2, 3};
  spot.target = {1, -4, 3};
  spot.intensity = rgb(2, 4, 6);
  spot.cone_angle = 89;
  spot.edge_angle = 0;
  spot.up = {0, 5, -2};
  spot.image_angle = 60;
  spot.image = std::move(image);
  return spot;
}

// What it sends to a point `right` and `up` of the axis, at a distance of 1 along it: I over the intensity without image.
double thrown(const SpotLight& spot, double right, double up) {
  const Vec3 p = spot.position + Vec3(static_cast<float>(right), -1, static_cast<float>(-up));
  const auto sample = spot.sample(p);
  return sample ? sample->radiance.b / 6.0 * sqr(static_cast<double>(sample->distance)) : 0;
}

const double half = std::tan(glm::radians(30.0));

TEST(Slide, LiesBeforeItsLightAsInItsFile) {
  const SpotLight spot = projector(image_of(4, 2, value_at));
  for (int y = 0; y < 2; ++y)
    for (int x = 0; x < 4; ++x)
      EXPECT_NEAR(thrown(spot, 2 * half * ((x + 0.5) / 2 - 1), half * (y + 0.5 - 1)), value_at(x, y), 1e-4)
          << x << ' ' << y;
  EXPECT_NEAR(thrown(spot, 0, 0), (value_at(1, 0) + value_at(2, 1)) / 2, 1e-4) << "between texels, bilinear";
  EXPECT_NEAR(thrown(spot, 1.999 * half, 0.999 * half), value_at(3, 1), 1e-4);
  for (const auto& [right, up] : {std::pair{2.001, 0.0}, {-2.001, 0.0}, {0.0, 1.001}, {0.0, -1.001}})
    EXPECT_EQ(thrown(spot, right * half, up * half), 0) << right << ' ' << up;
  EXPECT_FALSE(spot.sample(spot.position + Vec3(0, 1, 0))) << "behind the light";
}

TEST(Slide, TurnsAndStretchesAsAsked) {
  SpotLight spot = projector(image_of(4, 2, value_at));
  spot.image_mirrored = true;
  EXPECT_NEAR(thrown(spot, 1.5 * half, 0.5 * half), value_at(0, 1), 1e-4);
  spot.image_mirrored = false;
  spot.image_aspect = 1;
  EXPECT_NEAR(thrown(spot, 0.75 * half, 0.5 * half), value_at(3, 1), 1e-4);
  EXPECT_EQ(thrown(spot, 1.01 * half, 0), 0);
  spot.image_aspect = 0.5f;
  EXPECT_NEAR(thrown(spot, 0.75 * half, half), value_at(3, 1), 1e-4) << "now upright, its shorter side 60°";
  spot.image_aspect = 0;
  spot.up = {1, 0, 0};
  EXPECT_NEAR(thrown(spot, 0.5 * half, 1.5 * half), value_at(0, 1), 1e-4) << "its right edge towards +z";
}

TEST(Slide, CoversTheConeIfItIsNotToldAndFadesWithIt) {
  SpotLight spot = projector(image_of(1, 1, [](int, int) { return 3; }));
  spot.image_angle = 0;
  spot.cone_angle = 30;
  EXPECT_NEAR(thrown(spot, 0.99 * half, 0), 3, 1e-4);
  EXPECT_EQ(thrown(spot, 0.8 * half, 0.8 * half), 0) << "in the corner, beyond the cone";
  spot.edge_angle = 30;
  spot.edge = SpotEdge::linear;
  EXPECT_NEAR(thrown(spot, std::tan(glm::radians(10.0)), 0), 2, 1e-4);
}

// The solid angle of a rectangle seen from before its middle is 4 asin(sin α/2 sin β/2), α and β its apex angles.
TEST(Slide, SendsThePowerOfItsTexels) {
  const SpotLight white = projector(image_of(200, 100, [](int, int) { return 1; }));
  const double wide = std::atan(2 * half), high = std::atan(half);
  const double solid_angle = 4 * std::asin(std::sin(wide) * std::sin(high));
  EXPECT_NEAR(white.power() / (luminance(white.intensity) * solid_angle), 1, 1e-4);
  EXPECT_NEAR(white.slide().corner_angle(), std::atan(std::sqrt(5.0) * half), 1e-6);
  // One with a picture and a soft cone, against the mean over the sphere of what sample() says: noise of 0.3 %.
  SpotLight spot = projector(image_of(40, 20, [](int x, int y) { return (x / 5 + y / 5) % 2; }));
  spot.cone_angle = 40;
  spot.edge_angle = 20;
  Random random(5);
  double sum = 0;
  constexpr int n = 400000;
  for (int i = 0; i < n; ++i) {
    Vec3d d = random.direction();
    d.y = -std::abs(d.y);
    const auto sample = spot.sample(Vec3(Vec3d(spot.position) + d));
    if (sample) sum += static_cast<double>(luminance(sample->radiance)) * sqr(sample->distance);
  }
  EXPECT_NEAR(spot.power() / (sum * 2 * pi_d / n), 1, 0.015);
}

// The middles of these four texels lie outside the cone.
TEST(Slide, OfTexelsWiderThanTheConeSendsWhatTheConeLetsThrough) {
  SpotLight spot = projector(image_of(2, 2, [](int, int) { return 1; }));
  spot.image_angle = 150;
  spot.cone_angle = 3;
  spot.edge_angle = 0;
  const double solid_angle = 2 * pi_d * (1 - std::cos(glm::radians(3.0)));
  EXPECT_NEAR(spot.power() / (luminance(spot.intensity) * solid_angle), 1, 1e-3);
}

TEST(Slide, BoundsItsIntensityByItsBrightestTexel) {
  const SpotLight spot = projector(image_of(4, 2, value_at));
  EXPECT_NEAR(spot.bounds().intensity, 8 * static_cast<double>(luminance(spot.intensity)), 1e-5);
}

}  // namespace
}  // namespace umbral
