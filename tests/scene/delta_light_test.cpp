// Point, spot and distant lights: inverse squares, falloff, directions and power.
#include <gtest/gtest.h>

#include "scene/lights/distant.h"
#include "scene/lights/point.h"
#include "scene/lights/spot.h"
#include "support/quadrature.h"
#include "support/random.h"

namespace umbral {
namespace {

using namespace test;

TEST(PointLight, FallsWithTheSquareOfTheDistance) {
  Random random(1);
  const PointLight lamp{{1, 2, 3}, rgb(10, 20, 30)};
  for (int i = 0; i < 1000; ++i) {
    const double r = random.log_between(1e-3, 1e3);
    const Vec3d d = random.direction();
    const Vec3 p(Vec3d(lamp.position) + r * d);
    const double distance = glm::length(Vec3d(p) - Vec3d(lamp.position));
    const auto sample = lamp.sample(p);
    ASSERT_TRUE(sample);
    EXPECT_TRUE(sample->delta);
    EXPECT_EQ(sample->pdf, 1);
    EXPECT_EQ(sample->target, lamp.position);
    EXPECT_NEAR(sample->distance, distance, 1e-6 * distance);
    for (int c = 0; c < 3; ++c) EXPECT_NEAR(sample->radiance[c] * sqr(distance) / lamp.intensity[c], 1, 1e-6);
    EXPECT_EQ(sample->irradiance(), sample->radiance);
    EXPECT_NEAR(glm::length(sample->wi), 1, 1e-6);
    EXPECT_GT(dot(sample->wi, lamp.position - p), 0.999f * sample->distance);
  }
  EXPECT_FALSE(lamp.sample(lamp.position)) << "no direction leads from a place to itself";
  EXPECT_NEAR(lamp.power(), 4 * pi_d * luminance(lamp.intensity), 1e-5 * lamp.power());
}

// The share of its intensity that a spot sends at this angle from its axis.
double share_at(const SpotLight& spot, double degrees) {
  const double angle = glm::radians(degrees);
  const Vec3d axis = glm::normalize(Vec3d(spot.target) - Vec3d(spot.position));
  const Vec3d across = glm::normalize(cross(axis, Vec3d(0.3, -0.5, 0.8)));
  const auto sample =
      spot.sample(Vec3(Vec3d(spot.position) + 2.0 * (std::cos(angle) * axis + std::sin(angle) * across)));
  return sample ? sample->radiance.g * sqr(static_cast<double>(sample->distance)) / spot.intensity.g : 0;
}

SpotLight spot_of(float cone, float edge) { return {{1, 2, 3}, {2, 0, -4}, rgb(5, 7, 9), cone, edge}; }

TEST(SpotLight, FadesBySmoothStepFromTheEdgeToTheCone) {
  const SpotLight spot = spot_of(40, 10);
  for (const double inside : {0.0, 10.0, 29.9}) EXPECT_NEAR(share_at(spot, inside), 1, 2e-6) << inside;
  for (const double angle : {31.0, 32.5, 35.0, 38.0, 39.5}) {
    const double t = (40 - angle) / 10;
    EXPECT_NEAR(share_at(spot, angle), t * t * (3 - 2 * t), 1e-4) << angle;
  }
  for (const double outside : {40.1, 60.0, 90.0, 179.0}) EXPECT_EQ(share_at(spot, outside), 0) << outside;
}

TEST(SpotLight, FadesStraightOrByItsCosineWhereAsked) {
  SpotLight spot = spot_of(40, 10);
  const double end = std::cos(glm::radians(40.0)), full = std::cos(glm::radians(30.0));
  for (const double angle : {31.0, 32.5, 35.0, 38.0, 39.5}) {
    spot.edge = SpotEdge::linear;
    EXPECT_NEAR(share_at(spot, angle), (40 - angle) / 10, 1e-4) << angle;
    spot.edge = SpotEdge::smooth_cosine;
    const double t = (std::cos(glm::radians(angle)) - end) / (full - end);
    EXPECT_NEAR(share_at(spot, angle), t * t * (3 - 2 * t), 1e-4) << angle;
  }
  for (const SpotEdge edge : {SpotEdge::linear, SpotEdge::smooth_cosine}) {
    spot.edge = edge;
    EXPECT_NEAR(share_at(spot, 29.9), 1, 2e-6);
    EXPECT_EQ(share_at(spot, 40.1), 0);
  }
}

TEST(SpotLight, MayEndSharplyFadeAllOverOrShineEverywhere) {
  EXPECT_NEAR(share_at(spot_of(40, 0), 39.99), 1, 2e-6);
  EXPECT_EQ(share_at(spot_of(40, 0), 40.01), 0);
  // An edge wider than the cone is as wide as the cone.
  EXPECT_NEAR(share_at(spot_of(20, 90), 10), 0.5, 1e-4);
  EXPECT_NEAR(share_at(spot_of(20, 90), 0), 1, 1e-4);
  EXPECT_NEAR(share_at(spot_of(180, 0), 179.9), 1, 2e-6);
  EXPECT_NEAR(share_at(spot_of(180, 60), 150), 0.5, 1e-4);
}

TEST(SpotLight, SendsThePowerThatItSays) {
  for (const auto& [cone, edge] :
       {std::pair{30.0f, 5.0f}, {60.0f, 60.0f}, {90.0f, 1.0f}, {180.0f, 30.0f}, {5.0f, 1.0f}}) {
    const SpotLight spot = spot_of(cone, edge);
    // The smooth step has a kink in its second derivative at the edge.
    const double start = cone - std::min(edge, cone);
    const auto over = [&](double low, double high) {
      return integral<32>(low, high, [&](double a) { return share_at(spot, a) * std::sin(glm::radians(a)); });
    };
    const double power =
        2 * pi_d * luminance(spot.intensity) * glm::radians(over(0, start) + over(start, cone));
    EXPECT_NEAR(spot.power() / power, 1, 0.02) << cone << ", " << edge;
  }
}

TEST(SpotLight, FallsWithTheSquareOfTheDistance) {
  const SpotLight spot = spot_of(40, 10);
  const Vec3 axis = glm::normalize(spot.target - spot.position);
  for (const float r : {0.1f, 1.0f, 50.0f})
    EXPECT_NEAR(spot.sample(spot.position + r * axis)->radiance.b * r * r, 9, 1e-4);
  EXPECT_FALSE(spot.sample(spot.position));
}

TEST(DistantLight, IsTheSameEverywhere) {
  const DistantLight sun{{0, -3, -4}, rgb(1, 2, 3)};
  for (const Vec3& p : {Vec3(0, 0, 0), Vec3(1e6f, -5, 2)}) {
    const auto sample = sun.sample(p);
    ASSERT_TRUE(sample);
    EXPECT_TRUE(sample->delta);
    EXPECT_EQ(sample->radiance, sun.irradiance);
    EXPECT_EQ(sample->pdf, 1);
    EXPECT_EQ(sample->distance, infinity);
    EXPECT_NEAR(glm::length(sample->wi - Vec3(0, 0.6f, 0.8f)), 0, 1e-6);
  }
  EXPECT_NEAR(sun.power(10), pi_d * 100 * luminance(sun.irradiance), 1e-3);
}

}  // namespace
}  // namespace umbral
