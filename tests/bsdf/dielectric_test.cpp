// Glass: shares of reflection and refraction, and what becomes of radiance on the way in and out.
#include "bsdf/lobes/dielectric.h"

#include <gtest/gtest.h>

#include "lobe_examples.h"

namespace umbral {
namespace {

using namespace test;

// The share of u1 for which the sample stays on wo's side, to 1/65536.
double reflected_share(const Dielectric& glass, const Vec3& wo) {
  constexpr int steps = 1 << 16;
  int reflected = 0;
  for (int i = 0; i < steps; ++i) {
    const auto sample = glass.sample(wo, (static_cast<float>(i) + 0.5f) / steps, {0, 0});
    reflected += sample && same_side(wo, sample->wi);
  }
  return static_cast<double>(reflected) / steps;
}

TEST(Dielectric, SharesLightByFresnelFromBothSides) {
  const Dielectric glass;
  for (const double c : {1.0, 0.8, 0.5, 0.1}) {
    EXPECT_NEAR(reflected_share(glass, direction_at(c, 1)), fresnel_dielectric(static_cast<float>(c), 1.5f),
                2e-5);
    EXPECT_NEAR(reflected_share(glass, direction_at(-c, 1)),
                fresnel_dielectric(static_cast<float>(c), 1 / 1.5f), 2e-5);
  }
}

TEST(Dielectric, ScalesRadianceByTheSquareOfTheIndex) {
  const Dielectric water{1.33f, rgb(0.9f, 0.8f, 0.7f), rgb(0.6f, 0.5f, 0.4f)};
  const Vec3 outside = direction_at(0.8, 2);
  const auto in = water.sample(outside, one_minus_epsilon, {0, 0});
  ASSERT_TRUE(in);
  EXPECT_LT(in->wi.z, 0);
  const auto out = water.sample(in->wi, one_minus_epsilon, {0, 0});
  ASSERT_TRUE(out);
  EXPECT_NEAR(glm::length(out->wi - outside), 0, 1e-6);
  for (int c = 0; c < 3; ++c) {
    EXPECT_NEAR(in->weight[c], water.transmittance[c] / sqr(1.33f), 1e-6);
    EXPECT_NEAR(out->weight[c], water.transmittance[c] * sqr(1.33f), 1e-6);
    EXPECT_NEAR(in->weight[c] * out->weight[c], sqr(water.transmittance[c]), 1e-6);
  }
}

TEST(Dielectric, ReflectsWithItsTintIntoTheMirrorDirection) {
  const Dielectric glass{1.5f, rgb(0.9f, 0.8f, 0.7f), white};
  for (const Vec3& wo : {direction_at(0.6, 1), direction_at(-0.9, 4)}) {
    const auto sample = glass.sample(wo, 0, {0, 0});
    ASSERT_TRUE(sample);
    EXPECT_EQ(sample->wi, Vec3(-wo.x, -wo.y, wo.z));
    EXPECT_EQ(sample->weight, glass.reflectance);
  }
}

TEST(Dielectric, ReflectsAllFromInsideBeyondTheCriticalAngle) {
  const Dielectric glass;
  const double critical = std::sqrt(1 - 1 / sqr(1.5));
  for (const float u1 : {0.0f, 0.5f, one_minus_epsilon}) {
    const Vec3 wo = direction_at(-critical * 0.99, 3);
    const auto sample = glass.sample(wo, u1, {0, 0});
    ASSERT_TRUE(sample);
    EXPECT_LT(sample->wi.z, 0);
    EXPECT_EQ(sample->weight, white);
  }
}

TEST(Dielectric, IsNotThereWhereTheIndexIsOne) {
  const Dielectric nothing{1.0f};
  for (const Vec3& wo : {direction_at(0.6, 1), direction_at(-0.01, 4), direction_at(1, 0)}) {
    const auto sample = nothing.sample(wo, 0, {0, 0});
    ASSERT_TRUE(sample);
    EXPECT_NEAR(glm::length(sample->wi + wo), 0, 1e-4);
    EXPECT_EQ(sample->weight, white);
  }
}

}  // namespace
}  // namespace umbral
