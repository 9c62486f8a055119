// Layers: cloth and coated metals, and metals that are brushed.
#include <gtest/gtest.h>

#include "bsdf/coat.h"
#include "bsdf/fresnel.h"
#include "bsdf/fuzz.h"
#include "bsdf/sheen.h"
#include "lobe_examples.h"

namespace umbral {
namespace {

using namespace test;

template <class Lobe>
double albedo_by_draws(const Lobe& lobe, const Vec3& wo, int draws = 20'000) {
  Random random(11);
  double sum = 0;
  for (int i = 0; i < draws; ++i) {
    const float u1 = (static_cast<float>(i) + random.number()) / static_cast<float>(draws);
    const auto sample = lobe.sample(wo, std::min(u1, one_minus_epsilon), random.square());
    if (sample) sum += sample->weight.g;
  }
  return sum / draws;
}

// Standard errors are below 0.003.
TEST(Sheen, LosesNothingOnAWhiteBody) {
  for (const float roughness : {0.0f, 0.2f, 0.5f, 1.0f})
    for (const double c : {1.0, 0.5, 0.2, 0.05})
      EXPECT_NEAR(albedo_by_draws(Sheen{white, white, roughness}, direction_at(c, 1)), 1, 0.015)
          << roughness << " " << c;
}

TEST(Sheen, ShinesAtItsEdges) {
  const Sheen velvet{black, white, 0.3f};
  EXPECT_GT(albedo_by_draws(velvet, direction_at(0.1, 1)),
            20 * albedo_by_draws(velvet, direction_at(0.9, 1)));
}

TEST(Sheen, WithoutFuzzIsMatte) {
  const Sheen bare{rgb(0.8f, 0.4f, 0.2f), black, 0.5f};
  const Vec3 wo = direction_at(0.7, 1), wi = direction_at(0.4, 5);
  for (int c = 0; c < 3; ++c) EXPECT_NEAR(bare.f_cos(wo, wi)[c], bare.reflectance[c] * 0.4 / pi_d, 1e-7);
}

// The skin takes from the metal the larger of what it reflects both ways: up to 5 % more than it gives.
TEST(Coat, LosesLittleOnAMirror) {
  for (const float roughness : {0.0f, 0.5f})
    for (const float metal_roughness : {0.0f, 0.4f})
      for (const double c : {1.0, 0.6, 0.2}) {
        Coat coat;
        coat.roughness = roughness;
        coat.reflectance = white;
        coat.metal_roughness = metal_roughness;
        const double albedo = albedo_by_draws(coat, direction_at(c, 1));
        EXPECT_GT(albedo, metal_roughness == 0 ? 0.985 : 0.93) << roughness << " " << c;
        EXPECT_LT(albedo, 1.01) << roughness << " " << c;
      }
}

// Twice through a layer of half the light, and off a metal of 0.9.
TEST(Coat, TintsWhatGoesThroughTwice) {
  Coat coat;
  coat.eta = 1.5f;
  coat.roughness = coat.metal_roughness = 0;
  coat.transmittance = rgb(1, 0.5f, 0.1f);
  const auto metal = coat.sample({0, 0, 1}, one_minus_epsilon, {0.5f, 0.5f});
  const auto skin = coat.sample({0, 0, 1}, 0, {0.5f, 0.5f});
  ASSERT_TRUE(metal && skin);
  // Each weight is a share over the chance to draw it.
  const double chance = 0.04 / skin->weight.g;
  for (int c = 0; c < 3; ++c)
    EXPECT_NEAR(metal->weight[c] * (1 - chance), 0.96 * sqr(coat.transmittance[c]) * 0.9, 1e-5);
}

TEST(Coat, IsTheMetalWhereThereIsNoLayer) {
  Coat coat;
  coat.eta = 1;
  Conductor metal;
  metal.roughness = coat.metal_roughness;
  const Vec3 wo = direction_at(0.7, 1), wi = direction_at(0.5, 3.5);
  for (int c = 0; c < 3; ++c) EXPECT_NEAR(coat.f_cos(wo, wi)[c], metal.f_cos(wo, wi)[c], 1e-6);
}

TEST(Conductor, IsBrushedAlongItsTurnedTangent) {
  Conductor metal;
  metal.roughness = 0.4f;
  metal.anisotropy = 0.8f;
  const Vec3 wo{0, 0, 1}, along = direction_at(0.8, 0), across = direction_at(0.8, pi_d / 2);
  EXPECT_GT(metal.f_cos(wo, along).g, 10 * metal.f_cos(wo, across).g);
  Conductor quarter = metal;
  quarter.anisotropy_rotation = 90;
  EXPECT_NEAR(quarter.f_cos(wo, across).g, metal.f_cos(wo, along).g, 1e-5 * metal.f_cos(wo, along).g);
}

}  // namespace
}  // namespace umbral
