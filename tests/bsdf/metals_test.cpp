// What metals reflect: their known colours, and Fresnel's equations for them.
#include "bsdf/interfaces/metals.h"

#include <gtest/gtest.h>

#include "bsdf/interfaces/fresnel.h"
#include "bsdf/lobes/conductor.h"

namespace umbral {
namespace {

TEST(Metals, ReflectWhatIsKnownOfThem) {
  const auto color = [](Metal metal) {
    const ComplexIndex index = metal_index(metal);
    return fresnel_conductor(1, index.eta, index.k);
  };
  const Spectrum gold = color(Metal::Au), silver = color(Metal::Ag), copper = color(Metal::Cu);
  EXPECT_NEAR(gold.r, 0.994, 2e-3);
  EXPECT_NEAR(gold.g, 0.789, 2e-3);
  EXPECT_NEAR(gold.b, 0.337, 2e-3);
  EXPECT_GT(min_component(silver), 0.9);
  EXPECT_TRUE(copper.r > copper.g && copper.g > copper.b);
  const Spectrum brass = color(Metal::CuZn);
  EXPECT_NEAR(brass.r, 0.896, 2e-3);
  EXPECT_NEAR(brass.g, 0.781, 2e-3);
  EXPECT_NEAR(brass.b, 0.414, 2e-3);
  EXPECT_NEAR(color(Metal::MgO).g, sqr((1.74 - 1) / (1.74 + 1)), 1e-3);
  EXPECT_NEAR(color(Metal::TiO2).g, sqr((2.95 - 1) / (2.95 + 1)), 2e-3);
  for (std::size_t i = 1; i < EnumNames<Metal>::names.size(); ++i) {
    const auto metal = static_cast<Metal>(i);
    EXPECT_LE(max_component(color(metal)), 1) << EnumNames<Metal>::names[i];
    if (metal != Metal::MgO) {
      EXPECT_GT(min_component(color(metal)), 0.2) << EnumNames<Metal>::names[i];
    }
    const ComplexIndex index = metal_index(metal);
    EXPECT_GT(min_component(fresnel_conductor(1e-4f, index.eta, index.k)), 0.995)
        << EnumNames<Metal>::names[i];
    // The two-point rule for the mean over the hemisphere, against a fine one.
    Conductor lobe;
    lobe.metal = metal;
    Spectrum mean = black;
    for (int k = 0; k < 2000; ++k) {
      const float c = (static_cast<float>(k) + 0.5f) / 2000;
      mean += lobe.fresnel(c) * (2 * c / 2000);
    }
    // What is clear, like MgO, reflects little until close to the edge, which two points see less of; only what is
    // reflected twice, a hundredth there, depends on it.
    const double allowed = metal == Metal::MgO ? 1e-2 : 8e-3;
    for (int c = 0; c < 3; ++c)
      EXPECT_NEAR(lobe.fresnel_average()[c], mean[c], allowed) << EnumNames<Metal>::names[i];
  }
}

// A real index is a dielectric's.
TEST(Fresnel, OfAMetalWithoutAbsorptionIsThatOfADielectric) {
  for (const float eta : {1.33f, 1.5f, 2.4f})
    for (const double c : {1.0, 0.7, 0.3, 0.1, 0.01})
      EXPECT_NEAR(fresnel_conductor(static_cast<float>(c), grey(eta), black).g,
                  fresnel_dielectric(static_cast<float>(c), eta), 2e-6);
}

TEST(Fresnel, OfSchlickWithAnEdgeTintHasItsValuesAndMean) {
  const Spectrum f0 = rgb(0.9f, 0.5f, 0.3f), tint = rgb(1, 0.6f, 0.5f);
  for (int c = 0; c < 3; ++c) {
    EXPECT_FLOAT_EQ(fresnel_schlick(1, f0, tint)[c], f0[c]);
    EXPECT_FLOAT_EQ(fresnel_schlick(0, f0, tint)[c], 1);
    const float schlick = f0[c] + (1 - f0[c]) * std::pow(6 / 7.0f, 5.0f);
    EXPECT_NEAR(fresnel_schlick(1 / 7.0f, f0, tint)[c], schlick * tint[c], 1e-6);
    double mean = 0;
    for (int k = 0; k < 2000; ++k) {
      const float cosine = (static_cast<float>(k) + 0.5f) / 2000;
      mean += fresnel_schlick(cosine, f0, tint)[c] * 2 * cosine / 2000;
    }
    EXPECT_NEAR(fresnel_schlick_average(f0, tint)[c], mean, 1e-4);
  }
  EXPECT_EQ(fresnel_schlick(0.3f, white, white).g, 1);
}

}  // namespace
}  // namespace umbral
