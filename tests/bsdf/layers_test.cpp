// Layers: cloth, and coats over anything.
#include <gtest/gtest.h>

#include "albedo_by_draws.h"
#include "bsdf/interfaces/fresnel.h"
#include "bsdf/layers/fuzz.h"
#include "bsdf/lobes/coat.h"
#include "bsdf/lobes/sheen.h"
#include "lobe_examples.h"
#include "support/stability.h"

namespace umbral {
namespace {

using namespace test;

// Standard errors are below 0.003.
TEST(Sheen, LosesNothingOnAWhiteBody) {
  for (const float roughness : {0.0f, 0.2f, 0.5f, 1.0f})
    for (const double c : {1.0, 0.5, 0.2, 0.05})
      EXPECT_NEAR(albedo_by_draws(Sheen{white, white, roughness}, direction_at(c, 1)).mean, 1, 0.015)
          << roughness << " " << c;
}

TEST(Sheen, ShinesAtItsEdges) {
  const Sheen velvet{black, white, 0.3f};
  EXPECT_GT(albedo_by_draws(velvet, direction_at(0.1, 1)).mean,
            20 * albedo_by_draws(velvet, direction_at(0.9, 1)).mean);
}

TEST(Sheen, WithoutFuzzIsMatte) {
  const Sheen bare{rgb(0.8f, 0.4f, 0.2f), black, 0.5f};
  const Vec3 wo = direction_at(0.7, 1), wi = direction_at(0.4, 5);
  for (int c = 0; c < 3; ++c) EXPECT_NEAR(bare.f_cos(wo, wi)[c], bare.reflectance[c] * 0.4 / pi_d, 1e-7);
}

// Metals and matte bodies under any skin, at any angle; standard errors are below 0.002.
TEST(Coat, LosesNothingOverWhiteMetalsAndMatteBodies) {
  for (const float roughness : {0.0f, 0.1f, 0.5f})
    for (const float metal_roughness : {0.0f, 0.05f, 0.2f, 0.4f, 0.8f})
      for (const double c : {1.0, 0.6, 0.2, 0.1, 0.05}) {
        Conductor metal;
        metal.reflectance = white;
        metal.roughness = metal_roughness;
        const Lobes base = metal, matte = Lambert{white};
        EXPECT_NEAR(albedo_by_draws(Coat{&base, 1.5f, roughness}, direction_at(c, 1)).mean, 1, 0.006)
            << "skin " << roughness << ", metal " << metal_roughness << ", cos " << c;
        EXPECT_NEAR(albedo_by_draws(Coat{&matte, 1.5f, roughness}, direction_at(c, 1)).mean, 1, 0.006)
            << "skin " << roughness << ", matte, cos " << c;
      }
}

// Of lobes that are layers already, their parts share what the skin lets pass as if each had all of it.
TEST(Coat, LosesLittleOverAnyWhiteLobe) {
  Principled dielectric, metal;
  dielectric.roughness = metal.roughness = 0.3f;
  metal.metallic = 1;
  Conductor steel;
  steel.reflectance = white;
  const Lobes plastic = Plastic{white, 1.5f, 0.3f}, gloss = dielectric, chrome = metal, bare = steel,
              cloth = Sheen{white, white, 0.4f}, mixed = Mix{&plastic, &bare, 0.5f}, coated = Coat{&bare};
  double low = 1, high = 1;
  for (const Lobes* base : {&plastic, &gloss, &chrome, &cloth, &mixed, &coated})
    for (const float roughness : {0.0f, 0.4f})
      for (const double c : {1.0, 0.7, 0.4, 0.2, 0.1, 0.03}) {
        const double albedo = albedo_by_draws(Coat{base, 1.5f, roughness}, direction_at(c, 1)).mean;
        EXPECT_GT(albedo, 0.98) << kind_of(*base) << ", skin " << roughness << ", cos " << c;
        EXPECT_LT(albedo, base == &coated ? 1.016 : 1.01)
            << kind_of(*base) << ", skin " << roughness << ", cos " << c;
        low = std::min(low, albedo);
        high = std::max(high, albedo);
      }
  record({"Lobes", "a clear coat over a lobe that loses nothing loses or makes light",
          "between 0.98 and 1.016", fmt::format("{:.3f} to {:.3f}", low, high)});
}

// Both layers let pass more along the normal; standard errors are below 0.002.
TEST(Coat, MakesNoLightOverACoatOnAMatteBody) {
  const Lobes matte = Lambert{white}, varnished = Coat{&matte};
  for (const double c : {1.0, 0.6, 0.2})
    EXPECT_NEAR(albedo_by_draws(Coat{&varnished}, direction_at(c, 1)).mean, 1, 0.006) << c;
}

TEST(Coat, OverAMatteBodyIsPlastic) {
  const Spectrum color = rgb(0.9f, 0.5f, 0.1f);
  const Lobes matte = Lambert{color};
  for (const float roughness : {0.0f, 0.3f, 0.8f}) {
    const Plastic plastic{color, 1.6f, roughness};
    const Coat coat{&matte, 1.6f, roughness};
    for (const double z : {1.0, 0.5, 0.1})
      for (int c = 0; c < 3; ++c) {
        const Vec3 wo = direction_at(0.7, 1), wi = direction_at(z, 3.5);
        EXPECT_NEAR(coat.f_cos(wo, wi)[c], plastic.f_cos(wo, wi)[c], 2e-6 * plastic.f_cos(wo, wi)[c]);
      }
  }
}

// Once through the layer, off the metal and out; or back to the metal, and so on.
TEST(Coat, TintsWhatGoesThrough) {
  Conductor metal;
  metal.roughness = 0;
  const Lobes base = metal;
  const Coat coat{&base, 1.5f, 0, rgb(1, 0.5f, 0.1f)};
  const auto from_metal = coat.sample({0, 0, 1}, one_minus_epsilon, {0.5f, 0.5f});
  const auto from_skin = coat.sample({0, 0, 1}, 0, {0.5f, 0.5f});
  ASSERT_TRUE(from_metal && from_skin);
  // Each weight is a share over the chance to draw it.
  const double chance = 0.04 / from_skin->weight.g;
  for (int c = 0; c < 3; ++c) {
    double sum = 0, way = 0.96 * 0.9 * sqr(coat.transmittance[c]);
    for (int bounce = 0; bounce < 20; ++bounce, way *= 0.04 * 0.9 * sqr(coat.transmittance[c]))
      sum += way * 0.96;
    EXPECT_NEAR(from_metal->weight[c] * (1 - chance), sum, 1e-5);
  }
}

TEST(Coat, IsItsBaseWhereThereIsNoLayer) {
  const Lobes metal = Conductor{}, plastic = Plastic{}, matte = Lambert{};
  const Vec3 wo = direction_at(0.7, 1), wi = direction_at(0.5, 3.5);
  for (const Lobes* base : {&metal, &plastic, &matte})
    for (int c = 0; c < 3; ++c)
      EXPECT_NEAR((Coat{base, 1}.f_cos(wo, wi)[c]), f_cos(*base, wo, wi)[c], 1e-6 * f_cos(*base, wo, wi)[c]);
}

}  // namespace
}  // namespace umbral
