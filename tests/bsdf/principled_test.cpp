// The principled material: what glTF's texts say of it, and that its mixtures neither lose nor make light.
#include "bsdf/lobes/principled.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "albedo_by_draws.h"
#include "bsdf/interfaces/fresnel.h"
#include "bsdf/layers/fuzz.h"
#include "bsdf/lobes/conductor.h"
#include "bsdf/lobes/dielectric.h"
#include "lobe_examples.h"
#include "support/quadrature.h"

namespace umbral {
namespace {

using namespace test;

Principled white_of(float metallic, float transmission, bool thin, float roughness) {
  Principled lobe;
  lobe.metallic = metallic;
  lobe.transmission = transmission;
  lobe.thin_walled = thin;
  lobe.roughness = roughness;
  return lobe;
}

// Standard errors are below 0.002.
TEST(Principled, LosesNothingWhereItsBaseIsWhite) {
  for (const float roughness : {0.0f, 0.3f, 0.7f, 1.0f})
    for (const auto& [metallic, transmission, thin] : {std::tuple{0.0f, 0.0f, false},
                                                       {1.0f, 0.0f, false},
                                                       {0.0f, 1.0f, false},
                                                       {0.0f, 1.0f, true},
                                                       {0.4f, 0.3f, true},
                                                       {0.5f, 0.5f, false}})
      for (const double c : {1.0, 0.6, 0.2}) {
        const Principled lobe = white_of(metallic, transmission, thin, roughness);
        EXPECT_NEAR(albedo_by_draws(lobe, direction_at(c, 1)).mean, 1, 0.013)
            << fmt::format("metallic {}, transmission {}, thin {}, roughness {}, cos {}", metallic,
                           transmission, thin, roughness, c);
      }
}

// Parts of a mixture share what the layers let pass as if each had all of it: up to 1.7 % is lost at grazing angles.
TEST(Principled, LosesLittleUnderItsLayers) {
  for (const float metallic : {0.0f, 1.0f})
    for (const float roughness : {0.1f, 0.2f, 0.5f})
      for (const auto& [clearcoat, coat_roughness, sheen] :
           {std::tuple{1.0f, 0.0f, 0.0f}, {1.0f, 0.5f, 0.0f}, {0.0f, 0.0f, 1.0f}, {0.5f, 0.2f, 1.0f}})
        for (const double c : {1.0, 0.6, 0.2, 0.1, 0.05}) {
          Principled lobe = white_of(metallic, 0, false, roughness);
          lobe.clearcoat = clearcoat;
          lobe.clearcoat_roughness = coat_roughness;
          lobe.sheen_color = grey(sheen);
          lobe.sheen_roughness = 0.4f;
          const double albedo = albedo_by_draws(lobe, direction_at(c, 1), 10'000).mean;
          const std::string where = fmt::format("metallic {}, roughness {}, coat {} {}, sheen {}, cos {}",
                                                metallic, roughness, clearcoat, coat_roughness, sheen, c);
          EXPECT_GT(albedo, metallic == 1 ? 0.99 : 0.98) << where;
          EXPECT_LT(albedo, 1.01) << where;
        }
}

// Seen from outside, glass under a coat keeps all; light that leaves it loses what the coat reflects.
TEST(Principled, LosesWhatACoatReflectsOfLightFromInside) {
  Principled glass = white_of(0, 1, false, 0);
  glass.clearcoat = 1;
  const auto albedo = [&](double c) { return albedo_by_draws(glass, direction_at(c, 1)).mean; };
  EXPECT_GT(albedo(0.8), 0.99);
  EXPECT_GT(albedo(0.3), 0.98);
  EXPECT_NEAR(albedo(-1), 0.04 + 0.96 * 0.96, 0.005);
}

TEST(Principled, IsAConductorWhereItIsMetal) {
  Principled lobe;
  lobe.base_color = rgb(0.9f, 0.6f, 0.3f);
  lobe.metallic = 1;
  Conductor metal;
  metal.reflectance = lobe.base_color;
  metal.roughness = lobe.roughness;
  const Vec3 wo = direction_at(0.7, 1), wi = direction_at(0.5, 3.5);
  for (int c = 0; c < 3; ++c) EXPECT_NEAR(lobe.f_cos(wo, wi)[c], metal.f_cos(wo, wi)[c], 1e-6);
  EXPECT_NEAR(lobe.pdf(wo, wi), metal.pdf(wo, wi), 1e-6);
}

TEST(Principled, IsADielectricWhereItIsClear) {
  Principled lobe;
  lobe.base_color = rgb(0.9f, 0.6f, 0.3f);
  lobe.transmission = 1;
  const Dielectric glass{1.5f, white, lobe.base_color, lobe.roughness};
  for (const Vec3& wi : {direction_at(0.5, 3.5), direction_at(-0.8, 3.5)})
    EXPECT_EQ(lobe.f_cos(direction_at(0.7, 1), wi), glass.f_cos(direction_at(0.7, 1), wi));
}

// KHR_materials_specular: without strength there is no reflection, and the body is matte; the tint colours f0, not the
// horizon.
TEST(Principled, TintsItsSkinAsGltfSays) {
  Principled dull;
  dull.specular = 0;
  dull.base_color = rgb(0.8f, 0.4f, 0.2f);
  const Vec3 wo = direction_at(0.7, 1), wi = direction_at(0.5, 3.5);
  for (int c = 0; c < 3; ++c) EXPECT_NEAR(dull.f_cos(wo, wi)[c], dull.base_color[c] * 0.5 / pi_d, 1e-6);

  Principled tinted;
  tinted.base_color = black;
  tinted.roughness = 0;
  tinted.specular_color = rgb(1, 0.5f, 30);
  tinted.specular = 0.8f;
  const auto reflected = [&](double z) { return tinted.sample(direction_at(z, 0), 0, {0, 0})->weight; };
  const Spectrum f0 = reflected(1), edge = reflected(1e-4);
  EXPECT_NEAR(f0.r, 0.8 * 0.04, 1e-6);
  EXPECT_NEAR(f0.g, 0.8 * 0.02, 1e-6);
  EXPECT_NEAR(f0.b, 0.8, 1e-6) << "no more than all";
  for (int c = 0; c < 3; ++c) EXPECT_NEAR(edge[c], 0.8, 1e-3);
}

// The walls of a thin body do not bend light, and tint it once.
TEST(Principled, LetsLightGoStraightThroughThinWalls) {
  Principled pane;
  pane.transmission = 1;
  pane.thin_walled = true;
  pane.roughness = 0;
  pane.base_color = rgb(0.9f, 0.5f, 0.1f);
  const Vec3 wo = direction_at(0.6, 2);
  const auto sample = pane.sample(wo, 0.999f, {0.5f, 0.5f});
  ASSERT_TRUE(sample && sample->delta);
  EXPECT_EQ(sample->wi, -wo);
  for (int c = 0; c < 3; ++c) EXPECT_NEAR(sample->weight[c], pane.base_color[c], 1e-6);
  EXPECT_EQ(pane.interior_eta(), 1);
}

// However little: beside the least width that facets may have, 4e-8 would be no highlight that floats can hold.
TEST(Principled, IsAMirrorBelowTheLeastWidthWhereItIsStretchedToo) {
  Principled lobe = white_of(0, 1, true, 2e-4f);
  lobe.anisotropy = 3.6e-6f;
  EXPECT_TRUE(lobe.only_delta());
  lobe.anisotropy = 0.5f;
  EXPECT_FALSE(lobe.only_delta());
}

TEST(Principled, ShowsAFilmInPartOfItsSurface) {
  const auto reflected = [](float share) {
    Principled lobe;
    lobe.metallic = 1;
    lobe.roughness = 0;
    lobe.base_color = grey(0.6f);
    lobe.iridescence = share;
    return lobe.sample({0, 0, 1}, 0.5f, {0.5f, 0.5f})->weight;
  };
  const Spectrum bare = reflected(0), half = reflected(0.5f), whole = reflected(1);
  EXPECT_NEAR(bare.r, 0.6, 1e-6);
  EXPECT_GT(max_component(whole) - min_component(whole), 0.02) << "no colour";
  for (int c = 0; c < 3; ++c) EXPECT_NEAR(half[c], 0.5 * (bare[c] + whole[c]), 1e-6);
}

// The table against a quadrature of its own, in cosines.
TEST(Fuzz, ReflectsWhatItsTableSaysAndNoMoreThanAll) {
  for (const float roughness : {0.1f, 0.2f, 0.3f, 0.55f, 1.0f})
    for (const double c : {1.0, 0.5, 0.2, 0.05, 0.01, 0.001}) {
      const Fuzz fuzz = Fuzz::of_roughness(roughness);
      const double albedo = adaptive_integral<8>(
          {0, 1, 0, pi_d},
          [&](double x, double phi) {
            return 2 * 3 * x * x *
                   static_cast<double>(fuzz.f_cos(direction_at(c, 0), direction_at(x * x * x, phi)));
          },
          1e-4, 6);
      EXPECT_NEAR(fuzz.albedo(static_cast<float>(c)), albedo, 0.01) << roughness << " " << c;
      EXPECT_LE(albedo, 1.001) << roughness << " " << c;
    }
}

}  // namespace
}  // namespace umbral
