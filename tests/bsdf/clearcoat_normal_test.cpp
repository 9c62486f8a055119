// Principled materials whose clearcoat leans on what it covers: they neither make light nor lose much of it.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include "albedo_by_draws.h"
#include "bsdf/layers/skin.h"
#include "lobe_draws.h"
#include "lobe_text.h"

namespace umbral {
namespace {

using namespace test;

// Leaning that far (radians), that way.
Vec3 leaning(double by, double towards) { return direction_at(std::cos(by), towards); }

// Lobes with parameters from all over their ranges, under coats of which some lean as far as maps can make them.
std::vector<Principled> lobes_under_leaning_coats(std::size_t count) {
  Random random(21);
  std::vector<Principled> lobes;
  for (Principled lobe : lobe_examples<Principled>(1000)) {
    if (lobe.clearcoat < 0.05f) continue;
    take_film_off(lobe);
    lobe.anisotropy = 0;
    const double by = random.between(0.05, 1.4);
    lobe.clearcoat_normal = leaning(by, random.between(0, 2 * pi_d));
    lobes.push_back(lobe);
    if (lobes.size() == count) break;
  }
  return lobes;
}

// The coat alone, over something that is black.
Principled coat_of(const Principled& lobe) {
  Principled coat;
  coat.base_color = black;
  coat.specular = 0;
  coat.clearcoat = lobe.clearcoat;
  coat.clearcoat_roughness = lobe.clearcoat_roughness;
  coat.clearcoat_normal = lobe.clearcoat_normal;
  return coat;
}

// 2 % of the draws in the wrong place would be seen.
TEST(LeaningClearcoat, DrawsDirectionsByItsDensity) {
  Random random(22);
  for (Principled lobe : lobes_under_leaning_coats(6)) {
    lobe.roughness = std::max(lobe.roughness, 0.3f);
    lobe.clearcoat_roughness = std::max(lobe.clearcoat_roughness, 0.3f);
    for (const Vec3& wo : {direction_at(0.9, 1), direction_at(-0.3, 4)}) {
      SCOPED_TRACE(text_of(lobe, wo));
      constexpr int draws = 50'000;
      CountedDraws counted = counted_draws(lobe, wo, random, draws);
      EXPECT_LE(counted.total,
                1 + 1e-3);  // the density jumps at the coat's horizon, which goes through cells
      const ChiSquare chi = counted.chi_square(draws, counted.total);
      EXPECT_GT(chi.p, 1e-5) << "chi² " << chi.statistic << " with " << chi.degrees << " degrees of freedom";
    }
  }
}

TEST(LeaningClearcoat, SamplesAgreeWithEvaluation) {
  Random random(23);
  for (const Principled& lobe : lobes_under_leaning_coats(40))
    for (int i = 0; i < 500; ++i) {
      const Vec3 wo(random.direction());
      const auto sample = draw(lobe, wo, random);
      if (!sample) continue;
      EXPECT_NEAR(glm::length(sample->wi), 1, 1e-5);
      if (sample->delta) continue;
      SCOPED_TRACE(text_of(lobe, wo));
      EXPECT_EQ(sample->pdf, lobe.pdf(wo, sample->wi));
      const Spectrum f_cos = lobe.f_cos(wo, sample->wi);
      for (int c = 0; c < 3; ++c) EXPECT_NEAR(sample->weight[c] * sample->pdf, f_cos[c], 1e-6 * f_cos[c]);
    }
}

// The coat about its own normal, all the rest about its.
TEST(LeaningClearcoat, IsReciprocal) {
  Random random(24);
  int seen = 0;
  for (const Principled& lobe : lobes_under_leaning_coats(60)) {
    const Principled coat = coat_of(lobe);
    for (int i = 0; i < 500; ++i) {
      const Vec3 a(random.direction());
      Vec3 b(random.direction());
      if (const auto sample = draw(lobe, a, random); sample && i % 2 == 0) b = sample->wi;
      const float above_a = dot(a, lobe.clearcoat_normal), above_b = dot(b, lobe.clearcoat_normal);
      if (std::min({std::abs(a.z), std::abs(b.z), std::abs(above_a), std::abs(above_b)}) < 1e-2f) continue;
      SCOPED_TRACE(text_of(lobe, a));
      const float there = coat.f_cos(a, b).g / std::abs(above_b),
                  back = coat.f_cos(b, a).g / std::abs(above_a);
      // Which side is which is told by the body: it faces one direction of the two alone.
      if (same_side(a, b)) {
        EXPECT_NEAR(there, back, 1e-4 * there + 1e-30);
      }
      if (interior(Lobes(lobe)) && (a.z < 0 || b.z < 0)) continue;  // eta² beside what the coat lets pass
      const auto beneath = [&](const Vec3& wo, const Vec3& wi) {
        return (lobe.f_cos(wo, wi).g - (same_side(wo, wi) ? coat.f_cos(wo, wi).g : 0)) / std::abs(wi.z);
      };
      const float whole = lobe.f_cos(a, b).g / std::abs(b.z) + lobe.f_cos(b, a).g / std::abs(a.z);
      if (same_side(a, b)) {
        EXPECT_NEAR(beneath(a, b), beneath(b, a), 1e-5 * whole + 1e-30);
        seen += beneath(a, b) > 1e-3f;
      }
    }
  }
  EXPECT_GT(seen, 2000);
}

// Standard errors are below 0.003. Lost is what passes the coat one way and is reflected by it the other, as the light that
// a mirror beneath takes from near the coat's horizon.
TEST(LeaningClearcoat, MakesNoLightAndLosesLittle) {
  double least = 1;  // under coats that lean 11°, seen not too low
  for (const float metallic : {0.0f, 1.0f})
    for (const float roughness : {0.0f, 0.3f, 0.7f})
      for (const float coat_roughness : {0.0f, 0.4f})
        for (const double by : {0.2, 0.6, 1.2})
          for (const double towards : {1.0, 2.5, 4.0})
            for (const double c : {1.0, 0.6, 0.2}) {
              Principled lobe;
              lobe.metallic = metallic;
              lobe.roughness = roughness;
              lobe.clearcoat = 1;
              lobe.clearcoat_roughness = coat_roughness;
              lobe.clearcoat_normal = leaning(by, towards);
              const Vec3 wo = direction_at(c, 1);
              if (dot(wo, lobe.clearcoat_normal) < 0.02f) continue;  // no surface is shown from there
              const Albedo albedo = albedo_by_draws(lobe, wo, 5000);
              EXPECT_LT(albedo.mean, 1.01 + 4 * albedo.error)
                  << fmt::format("metallic {}, roughness {} {}, by {} towards {}, cos {}", metallic,
                                 roughness, coat_roughness, by, towards, c);
              if (by == 0.2 && c > 0.5) least = std::min(least, albedo.mean);
            }
  RecordProperty("least", fmt::format("{:.4f}", least));
  EXPECT_GT(least, 0.88);
}

TEST(LeaningClearcoat, MirrorsAboutItsOwnNormal) {
  Principled lobe;
  lobe.clearcoat = 1;
  for (const double by : {0.3, 0.8}) {
    lobe.clearcoat_normal = leaning(by, 0);
    const Vec3 wo = direction_at(0.8, pi_d - 0.5);
    const float cosine = dot(wo, lobe.clearcoat_normal);
    const auto sample = lobe.sample(wo, 0, {0.3f, 0.6f});
    ASSERT_TRUE(sample && sample->delta);
    EXPECT_LT(glm::length(sample->wi - (2 * cosine * lobe.clearcoat_normal - wo)), 1e-6f);
    // Where that is beneath the horizon of what it covers, it still is if nothing comes through from there.
    EXPECT_EQ(sample->wi.z < 0, by == 0.8);
    Principled clear = lobe;
    clear.transmission = 0.5f;
    EXPECT_EQ(clear.sample(wo, 0, {0.3f, 0.6f}).has_value(), by != 0.8);
  }
}

// Beneath its horizon a body that lets no light through sends none; what is there is the coat's.
TEST(LeaningClearcoat, ShinesAloneWhereItsBodyFacesAway) {
  Random random(25);
  int seen = 0;
  for (const Principled& lobe : lobes_under_leaning_coats(60)) {
    if (lobe.transmits()) continue;
    for (int i = 0; i < 300; ++i) {
      const Vec3 wo(random.direction()), wi(random.direction());
      if (same_side(wo, wi)) continue;
      const Spectrum f_cos = lobe.f_cos(wo, wi);
      EXPECT_EQ(f_cos, coat_of(lobe).f_cos(wo, wi)) << text_of(lobe, wo);
      seen += !is_black(f_cos);
      const Vec3& n = lobe.clearcoat_normal;
      if (dot(wo, n) * wo.z < 0 || dot(wo, n) * dot(wi, n) < 0) {
        EXPECT_TRUE(is_black(f_cos)) << "through the coat";
      }
    }
  }
  EXPECT_GT(seen, 100);
}

TEST(LeaningClearcoat, GoesOverContinuouslyIntoOneThatLiesLevel) {
  Random random(26);
  for (Principled lobe : lobes_under_leaning_coats(60)) {
    if (lobe.clearcoat_roughness < 0.3f) continue;
    Principled level = lobe;
    lobe.clearcoat_normal = leaning(1e-3, random.between(0, 2 * pi_d));
    ASSERT_NE(lobe.clearcoat_normal.z, 1);
    level.clearcoat_normal = {0, 0, 1};
    for (int i = 0; i < 200; ++i) {
      const Vec3 wo(random.direction()), wi(random.direction());
      if (std::min(std::abs(wo.z), std::abs(wi.z)) < 0.05f) continue;
      const float expected = level.f_cos(wo, wi).g, density = level.pdf(wo, wi);
      EXPECT_NEAR(lobe.f_cos(wo, wi).g, expected, 0.05 * expected) << text_of(lobe, wo);
      EXPECT_NEAR(lobe.pdf(wo, wi), density, 0.05 * density) << text_of(lobe, wo);
    }
  }
}

TEST(LeaningClearcoat, StaysFinite) {
  for (const Principled& lobe : lobes_under_leaning_coats(40))
    for (const double zo : {1.0, 0.5, 1e-4, -1e-8, 1e-42, -0.3})
      for (const double zi : {1.0, 0.5, 1e-4, -1e-8, 1e-42, -0.3}) {
        const Vec3 wo = direction_at(zo, 1), wi = direction_at(zi, 4);
        const Spectrum f_cos = lobe.f_cos(wo, wi);
        EXPECT_TRUE(is_finite(f_cos) && min_component(f_cos) >= 0) << text_of(lobe, wo) << " " << zi;
        EXPECT_TRUE(std::isfinite(lobe.pdf(wo, wi)) && lobe.pdf(wo, wi) >= 0)
            << text_of(lobe, wo) << " " << zi;
        for (const float u : {0.0f, 0x1p-32f, 0.5f, one_minus_epsilon})
          if (const auto sample = lobe.sample(wo, u, {u, 1 - u})) {
            EXPECT_TRUE(is_finite(sample->weight) && min_component(sample->weight) >= 0) << text_of(lobe, wo);
            EXPECT_TRUE(sample->delta || (std::isfinite(sample->pdf) && sample->pdf > 0));
          }
      }
}

}  // namespace
}  // namespace umbral
