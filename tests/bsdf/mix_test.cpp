// Mixtures: the weighted sum of two lobes in every respect, and the weights of mirrors among them.
#include "bsdf/lobes/mix.h"

#include <gtest/gtest.h>

#include "albedo_by_draws.h"
#include "lobe_examples.h"

namespace umbral {
namespace {

using namespace test;

const Vec3 wo = direction_at(0.7, 1), wi = direction_at(0.5, 3.5);

TEST(Mix, IsTheWeightedSumOfItsParts) {
  Random random(1);
  for (int i = 0; i < 2000; ++i) {
    const Lobes &a = random_part(random, false), &b = random_part(random, true);
    const float w = random.number();
    const Mix mix{&a, &b, w};
    const Vec3 o(random.direction()), d(random.direction());
    for (int c = 0; c < 3; ++c) {
      const float sum = (1 - w) * f_cos(a, o, d)[c] + w * f_cos(b, o, d)[c];
      EXPECT_NEAR(mix.f_cos(o, d)[c], sum, 1e-6 * sum);
      EXPECT_NEAR(mix.albedo()[c], (1 - w) * albedo(a)[c] + w * albedo(b)[c], 1e-6);
    }
    const float density = (1 - w) * pdf(a, o, d) + w * pdf(b, o, d);
    EXPECT_NEAR(mix.pdf(o, d), density, 1e-6 * density);
  }
}

// What has no weight is neither evaluated nor drawn.
TEST(Mix, OfOneAloneIsThatOne) {
  const Lobes red = Lambert{rgb(0.8f, 0.1f, 0.1f)}, metal = Conductor{}, glass = Dielectric{};
  for (const auto& [mix, part] : {std::pair{Mix{&red, &metal, 0}, red},
                                  {Mix{&red, &metal, 1}, metal},
                                  {Mix{&glass, &red, 1}, red},
                                  {Mix{&glass, &red, 0}, glass}}) {
    EXPECT_EQ(mix.f_cos(wo, wi), f_cos(part, wo, wi));
    EXPECT_EQ(mix.pdf(wo, wi), pdf(part, wo, wi));
    EXPECT_EQ(mix.only_delta(), only_delta(part));
    EXPECT_EQ(mix.transmits(), transmits(part));
    EXPECT_EQ(mix.interior().has_value(), interior(part).has_value());
    const auto drawn = mix.sample(wo, 0.4f, {0.3f, 0.6f}), alone = sample(part, wo, 0.4f, {0.3f, 0.6f});
    ASSERT_TRUE(drawn && alone);
    EXPECT_EQ(drawn->wi, alone->wi);
    EXPECT_EQ(drawn->weight, alone->weight);
  }
}

TEST(Mix, DrawsMirrorsAsOftenAsTheyWeigh) {
  const Lobes mirror = Mirror{rgb(0.9f, 0.8f, 0.7f)}, matte = Lambert{};
  const Mix mix{&matte, &mirror, 0.3f};
  constexpr int draws = 10'000;
  int mirrored = 0;
  for (int i = 0; i < draws; ++i) {
    const auto drawn = mix.sample(wo, (static_cast<float>(i) + 0.5f) / draws, {0.2f, 0.9f});
    ASSERT_TRUE(drawn);
    mirrored += drawn->delta;
    if (drawn->delta) {
      EXPECT_EQ(drawn->weight, rgb(0.9f, 0.8f, 0.7f));
    }
  }
  EXPECT_NEAR(mirrored, 0.3 * draws, 1);
  EXPECT_FALSE(mix.only_delta());
  EXPECT_TRUE((Mix{&mirror, &mirror, 0.5f}.only_delta()));
}

// Clear and frosted glass of one index: the white furnace from both sides; standard errors are below 0.003.
TEST(Mix, LosesNothingOfWhatItsPartsKeep) {
  const Lobes clear = Dielectric{}, frosted = Dielectric{1.5f, white, white, 0.4f};
  const Lobes paint = Plastic{white}, cloth = Lambert{white};
  const Mix inner{&paint, &cloth, 0.4f};
  const Lobes nested = inner;
  for (const double c : {1.0, 0.5, 0.1, -0.4, -0.9}) {
    EXPECT_NEAR(albedo_by_draws(Mix{&clear, &frosted, 0.6f}, direction_at(c, 1)).mean, 1, 0.012) << c;
    EXPECT_NEAR(albedo_by_draws(Mix{&cloth, &nested, 0.5f}, direction_at(c, 1)).mean, 1, 0.005) << c;
  }
}

TEST(Mix, HasTheInsideOfThePartThatHasOne) {
  Dielectric wine;
  wine.attenuation_color = rgb(0.5f, 0.1f, 0.1f);
  wine.attenuation_distance = 2;
  const Lobes glass = wine, matte = Lambert{};
  for (const Mix& mix : {Mix{&glass, &matte, 0.5f}, Mix{&matte, &glass, 0.5f}}) {
    ASSERT_TRUE(mix.interior());
    EXPECT_NEAR(mix.interior()->transmittance(2).r, 0.5, 1e-6);
  }
  EXPECT_FALSE((Mix{&matte, &matte, 0.5f}.interior()));
}

TEST(Mix, HasOneHighlightInItsLocalModel) {
  const Lobes dull = BlinnPhong{grey(0.4f), grey(0.2f), 9}, sharp = BlinnPhong{grey(0.1f), grey(0.2f), 999},
              matte = Lambert{grey(0.6f)};
  const BlinnPhongCoefficients both = Mix{&dull, &sharp, 0.5f}.local_model();
  EXPECT_NEAR(both.exponent, 99, 0.01) << "10 and 1000 have the mean 100";
  EXPECT_NEAR(both.kd.g, 0.25, 1e-6);
  EXPECT_NEAR(both.ks.g, 0.2, 1e-6);
  const BlinnPhongCoefficients one = Mix{&matte, &sharp, 0.25f}.local_model();
  EXPECT_NEAR(one.exponent, 999, 0.01) << "the matte part shines not";
  EXPECT_NEAR(one.ks.g, 0.05, 1e-6);
}

}  // namespace
}  // namespace umbral
