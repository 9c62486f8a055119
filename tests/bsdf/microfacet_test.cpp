// GGX facets: the published albedos, digits at narrow widths, the sampling's Jacobian, and surfaces that lose nothing.
#include "bsdf/facets/microfacet.h"

#include <array>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "albedo_by_draws.h"
#include "bsdf/facets/microfacet_albedo.h"
#include "bsdf/interfaces/fresnel.h"
#include "bsdf/lobes/conductor.h"
#include "bsdf/lobes/dielectric.h"
#include "bsdf/lobes/plastic.h"
#include "lobe_examples.h"
#include "support/stability.h"

namespace umbral {
namespace {

using namespace test;

// Standard errors are 0.0001 to 0.003 here.
void expect_lossless(const Albedo& albedo, double table_error, const std::string& where) {
  EXPECT_NEAR(albedo.mean, 1, table_error + 4 * albedo.error) << where;
  EXPECT_LT(albedo.error, 4e-3) << where;
}

TEST(Ggx, KeepsWhatIsKnownOfItsSingleBounce) {
  // E(cos θ) for F = 1 by quadrature, from the reference tables; 1 − ln 2 is exact.
  EXPECT_NEAR(1 - ggx_loss({1, 1}, {0, 0, 1}), 1 - std::log(2.0), 1e-3);
  const std::array cosines{1.0, 0.7, 0.5, 0.2, 0.05};
  const std::array<std::pair<float, std::array<double, 5>>, 4> rows{
      {{0.1f, {0.988, 0.981, 0.969, 0.905, 0.912}},
       {0.3f, {0.877, 0.845, 0.822, 0.839, 0.931}},
       {0.5f, {0.688, 0.683, 0.698, 0.790, 0.913}},
       {1.0f, {0.307, 0.379, 0.451, 0.642, 0.848}}}};
  for (const auto& [alpha, row] : rows)
    for (std::size_t i = 0; i < row.size(); ++i)
      EXPECT_NEAR(1 - ggx_loss({alpha, alpha}, direction_at(cosines[i], 1)), row[i], 1.5e-3)
          << "alpha " << alpha << ", cos " << cosines[i];
}

// The density in long double at half-vectors within five widths of the peak.
TEST(Ggx, KeepsTheDigitsOfNarrowPeaks) {
  Random random(1);
  double worst = 0;
  for (const float alpha : {1e-1f, 1e-2f, 1e-3f, 1e-4f})
    for (int i = 0; i < 2000; ++i) {
      const double slope = alpha * random.between(0, 5), phi = random.between(0, 6.28);
      const Vec3 h(glm::normalize(Vec3d(slope * std::cos(phi), slope * std::sin(phi), 1)));
      const long double a2 = static_cast<long double>(alpha) * alpha, x = h.x, y = h.y, z = h.z;
      const long double q = (x * x + y * y) / a2 + z * z;
      const auto expected = static_cast<double>(1 / (3.14159265358979323846L * a2 * q * q));
      worst = std::max(worst, std::abs(Ggx({alpha, alpha}).density(h) / expected - 1));
    }
  EXPECT_LE(worst, 2e-6);
  record({"Lobes", "GGX D near its peak, α from 0.1 to 1e-4, loses digits", "≤ 2e-6 relative",
          fmt::format("{:.1e}", worst), "c²(α²−1)+1 in single precision: ∞ at 1e-4"});
}

// Normals as seen from the horizon itself, by numbers from both ends of their range: unit, upward or none at all, and with
// the density that long double gives them.
TEST(Ggx, DrawsVisibleNormalsFromGrazingDirections) {
  using Real = long double;
  double worst = 0;
  int drawn = 0, none = 0;
  for (const float alpha : {1.0f, 0.1f, 1e-2f, 1e-3f})
    for (const double z : {0.0, 1e-42, 1e-30, 1e-18, 1e-8, 1e-4, 1e-2})
      for (const float x : {0.0f, 0x1p-32f, 0.3f, 0.5f, one_minus_epsilon})
        for (const float y : {0.0f, 0x1p-32f, 0x1p-24f, 0.01f, 0.5f, 0.99f, 0.9999f, one_minus_epsilon}) {
          const Ggx ggx{alpha, alpha};
          const Vec3 wo(0.6f * std::sqrt(1 - sqr(static_cast<float>(z))),
                        0.8f * std::sqrt(1 - sqr(static_cast<float>(z))), static_cast<float>(z));
          const Vec3 h = ggx.sample_visible_normal(wo, {x, y});
          ASSERT_TRUE(is_finite(h)) << alpha << " " << z << " " << x << " " << y;
          EXPECT_NEAR(glm::length(h), 1, 1e-6);
          EXPECT_GE(h.z, 0);
          const float pdf = ggx.visible_normal_pdf(wo, h);
          ASSERT_TRUE(std::isfinite(pdf) && pdf >= 0) << alpha << " " << z << " " << x << " " << y;
          if (!(dot(wo, h) > 1e-4f)) {  // seen edge on: its digits are those of the cosine
            ++none;
            continue;
          }
          ++drawn;
          const Real a2 = static_cast<Real>(alpha) * alpha, hx = h.x, hy = h.y, hz = h.z;
          const Real q = (hx * hx + hy * hy) / a2 + hz * hz,
                     density = 1 / (3.14159265358979323846L * a2 * q * q);
          const Real ox = wo.x, oy = wo.y, oz = wo.z, facing = ox * hx + oy * hy + oz * hz;
          const Real spread = std::sqrt(oz * oz + a2 * (ox * ox + oy * oy));
          const Real expected = 2 * facing * density / (oz + spread);
          worst = std::max(worst, static_cast<double>(std::abs(pdf / expected - 1)));
        }
  EXPECT_GT(drawn, 300);
  EXPECT_LE(worst, 1e-3) << "the cosine of 1e-4 has four digits";
  record({"Lobes", "visible normals drawn at and near the horizon are NaN or have no density",
          "finite, density within 1e-3", fmt::format("0 of {} not finite, {:.1e}", drawn + none, worst),
          "mitsuba2 #32 (NaN at cos θ = 0), pbrt-v4 #313 (u near 1)"});
}

TEST(Ggx, IsADistributionOfProjectedArea) {
  // ∫ D(h) cos θh dωh = 1, over slopes, in which it is ∫ D cos⁴ d²m.
  for (const Ggx& ggx : {Ggx{0.3f, 0.3f}, Ggx{0.05f, 0.6f}, Ggx{1, 1}}) {
    double sum = 0;
    constexpr int steps = 400;
    for (int i = 0; i < steps; ++i)
      for (int j = 0; j < 64; ++j) {
        // Slopes of the rings that hold equal shares of the area.
        const double share = (i + 0.5) / steps, r = std::sqrt(share / (1 - share)),
                     phi = 2 * pi_d * (j + 0.5) / 64;
        const Vec3 h(
            glm::normalize(Vec3d(ggx.alpha_x * r * std::cos(phi), ggx.alpha_y * r * std::sin(phi), 1)));
        const double density = ggx.density(h) * std::pow(h.z, 4) * ggx.alpha_x * ggx.alpha_y;
        sum += density * pi_d / sqr(1 - share) / (steps * 64.0);
      }
    EXPECT_NEAR(sum, 1, 1e-3) << ggx.alpha_x << " " << ggx.alpha_y;
  }
}

// The directions that two neighbouring numbers give lie as far apart as the density says: pdf = 1/|J|.
TEST(Ggx, DrawsMirroredDirectionsWithTheInverseOfTheJacobian) {
  Random random(2);
  int checked = 0;
  for (const Ggx& ggx : {Ggx{0.2f, 0.2f}, Ggx{0.1f, 0.7f}, Ggx{1, 1}, Ggx{0.5f, 0.02f}})
    for (int i = 0; i < 200; ++i) {
      const Vec3 wo = direction_at(random.between(0.05, 1), random.between(0, 6.28));
      const Vec2 u{static_cast<float>(random.between(0.05, 0.95)),
                   static_cast<float>(random.between(0.05, 0.95))};
      constexpr float d = 1 / 512.0f;
      const auto wi = [&](float x, float y) {
        const auto drawn = ggx.sample_reflection(wo, {u.x + x, u.y + y});
        return drawn ? Vec3d(*drawn) : Vec3d(0, 0, -1);
      };
      // Central differences of the fourth order.
      const Vec3d du = (8.0 * (wi(d, 0) - wi(-d, 0)) - (wi(2 * d, 0) - wi(-2 * d, 0))) / (12.0 * d);
      const Vec3d dv = (8.0 * (wi(0, d) - wi(0, -d)) - (wi(0, 2 * d) - wi(0, -2 * d))) / (12.0 * d);
      const Vec3 at(wi(0, 0));
      if (!(at.z > 0.05f)) continue;  // so do its neighbours reflect
      EXPECT_NEAR(ggx.reflection_pdf(wo, at) * glm::length(cross(du, dv)), 1, 0.01);
      ++checked;
    }
  EXPECT_GT(checked, 400);
}

// What the bound on the cap leaves away enters the surface: by bounded draws as much light is reflected as by all visible
// normals, and no fewer of them leave the surface. At alpha ≥ 1 the cap holds no more than half of a sphere.
TEST(Ggx, DrawsReflectionsFromAllNormalsThatReflectUpwards) {
  constexpr int steps = 256;
  for (const Ggx& ggx : {Ggx{0.05f, 0.05f}, Ggx{0.3f, 0.3f}, Ggx{0.7f, 0.7f}, Ggx{1, 1}, Ggx{0.1f, 0.9f},
                         Ggx{1.7f, 0.3f}, Ggx{1.9f, 1.2f}})
    for (const double c : {1.0, 0.8, 0.4, 0.1, 0.01}) {
      const Vec3 wo = direction_at(c, 0.7);
      int plain = 0, bounded = 0;
      double by_bounded = 0;
      for (int i = 0; i < steps * steps; ++i) {
        const Vec2 u = (Vec2(i % steps, i / steps) + 0.5f) / static_cast<float>(steps);
        plain += reflected(wo, ggx.sample_visible_normal(wo, u)).z > 0;
        const auto wi = ggx.sample_reflection(wo, u);
        if (!wi) continue;
        ++bounded;
        by_bounded += ggx.mirrored_pdf(wo, *wi) / ggx.reflection_pdf(wo, *wi);
      }
      constexpr double all = steps * steps;
      EXPECT_NEAR(by_bounded / all, plain / all, 0.002)
          << ggx.alpha_x << " " << ggx.alpha_y << " cosine " << c;
      EXPECT_GE(bounded / all, plain / all - 1e-4) << ggx.alpha_x << " " << ggx.alpha_y << " cosine " << c;
      if (ggx.is_round() && ggx.alpha_x == 1) {
        EXPECT_GE(bounded / all, 0.9999) << c;
      }
    }
}

// Weights multiply from bounce to bounce: in a narrow gap their second moment tells how heavy the tails of a pixel get.
TEST(Conductor, DrawsWithWeightsThatStayNearOne) {
  double worst = 0;
  for (const float roughness : {0.3f, 0.7f, 1.0f}) {
    Conductor lobe;
    lobe.reflectance = white;
    lobe.roughness = roughness;
    for (const double c : {0.95, 0.7, 0.4, 0.15}) {
      const Albedo albedo = albedo_by_draws(lobe, direction_at(c, 1), 100'000);
      const double second_moment = sqr(albedo.error) * 100'000 + sqr(albedo.mean);
      worst = std::max(worst, second_moment);
    }
  }
  EXPECT_LE(worst, 1.2) << "1.31 by all visible normals";
}

TEST(Conductor, LosesNothingAtAnyRoughnessWhereItsFacetsAreMirrors) {
  for (const float alpha : {0.001f, 0.01f, 0.05f, 0.1f, 0.3f, 0.5f, 0.8f, 1.0f}) {
    Conductor lobe;
    lobe.reflectance = white;
    lobe.roughness = std::sqrt(alpha);
    for (const double c : {1.0, 0.9, 0.7, 0.5, 0.2, 0.05, 0.01})
      expect_lossless(albedo_by_draws(lobe, direction_at(c, 1), 30'000), 0.003,
                      fmt::format("alpha {}, cos {}", alpha, c));
  }
}

TEST(Conductor, LosesNearlyNothingWhereItsFacetsAreStretched) {
  for (const float anisotropy : {0.5f, -0.9f})
    for (const float alpha : {0.1f, 0.5f}) {
      Conductor lobe;
      lobe.reflectance = white;
      lobe.roughness = std::sqrt(alpha);
      lobe.anisotropy = anisotropy;
      for (const double c : {1.0, 0.7, 0.3})
        for (const double phi : {0.0, 0.2, 0.8, 1.2, 1.4, 1.57})
          expect_lossless(albedo_by_draws(lobe, direction_at(c, phi), 30'000), 0.01,
                          fmt::format("alpha {}, anisotropy {}, cos {}, phi {}", alpha, anisotropy, c, phi));
    }
}

TEST(Dielectric, LosesNothingAtAnyRoughnessFromEitherSide) {
  for (const float eta : {1.33f, 2.4f})
    for (const float alpha : {0.01f, 0.3f, 1.0f}) {
      const Dielectric lobe{eta, white, white, std::sqrt(alpha)};
      for (const double c : {1.0, 0.5, 0.1, -0.05, -0.5, -0.75, -1.0})
        expect_lossless(albedo_by_draws(lobe, direction_at(c, 1), 40'000), 0.01,
                        fmt::format("eta {}, alpha {}, cos {}", eta, alpha, c));
    }
}

TEST(Plastic, LosesNothingAtAnyRoughnessWithAWhiteBody) {
  for (const float alpha : {0.0f, 0.01f, 0.1f, 0.5f, 1.0f}) {
    const Plastic lobe{white, 1.5f, std::sqrt(alpha)};
    for (const double c : {1.0, 0.7, 0.4, 0.1, 0.02})
      expect_lossless(albedo_by_draws(lobe, direction_at(c, 1), 30'000), 0.003,
                      fmt::format("alpha {}, cos {}", alpha, c));
  }
}

// The bounces between body and skin deepen the colour: twice reflected, it is squared.
TEST(Plastic, DeepensItsColor) {
  const Plastic lobe{rgb(0.8f, 0.4f, 0.1f), 1.5f, 0};
  const Vec3 wo = direction_at(0.9, 0), wi = direction_at(0.8, 3);
  const Spectrum f = lobe.f_cos(wo, wi);
  const double k = 0.5963458;  // of the known averages, for eta = 1.5
  for (int c = 0; c < 3; ++c) {
    const double body = lobe.reflectance[c] * (1 - k) / (1 - lobe.reflectance[c] * k);
    const double through = (1 - fresnel_dielectric(0.9f, 1.5f)) * (1 - fresnel_dielectric(0.8f, 1.5f));
    EXPECT_NEAR(f[c], through * body * 0.8 / pi_d / (1 - 0.0917780), 2e-3 * f[c]);
  }
}

// As alpha goes to its smallest, what a rough lobe reflects of a smooth field goes over into what the mirror does.
TEST(Conductor, GoesOverIntoTheMirror) {
  Conductor rough, smooth;
  rough.roughness = std::sqrt(Ggx::smallest_alpha) * 1.0001f;
  smooth.roughness = std::sqrt(Ggx::smallest_alpha) * 0.9999f;
  ASSERT_FALSE(rough.only_delta());
  ASSERT_TRUE(smooth.only_delta());
  double worst = 0;
  for (const double c : {1.0, 0.6, 0.2, 0.05}) {
    const Vec3 wo = direction_at(c, 1);
    const auto seen = [&](const Conductor& lobe) {
      double sum = 0;
      for (int i = 0; i < 128; ++i)
        for (int j = 0; j < 128; ++j) {
          const auto s = lobe.sample(
              wo, 0.3f, {(static_cast<float>(i) + 0.5f) / 128, (static_cast<float>(j) + 0.5f) / 128});
          if (s) sum += s->weight.g * (1 + 0.5 * std::sin(3 * s->wi.x) + 0.3 * s->wi.y * s->wi.z);
        }
      return sum / (128 * 128);
    };
    EXPECT_NEAR(seen(rough), seen(smooth), 2e-3) << "cos " << c;
    worst = std::max(worst, std::abs(seen(rough) - seen(smooth)));
  }
  record({"Lobes", "metal jumps where its roughness goes over into the mirror", "≤ 2e-3 of a smooth field",
          fmt::format("{:.1e}", worst), "pbrt-v3 #214"});
}

TEST(Dielectric, GoesOverIntoTheSmoothOne) {
  Dielectric rough, smooth;
  rough.roughness = std::sqrt(2 * Ggx::smallest_alpha) * 1.0001f;
  smooth.roughness = std::sqrt(2 * Ggx::smallest_alpha) * 0.9999f;
  ASSERT_FALSE(rough.only_delta());
  ASSERT_TRUE(smooth.only_delta());
  double worst = 0;
  for (const double c : {1.0, 0.6, 0.2, -0.9, -0.3}) {
    const Vec3 wo = direction_at(c, 1);
    const auto seen = [&](const Dielectric& lobe) {
      double sum = 0;
      for (int k = 0; k < 64; ++k)
        for (int i = 0; i < 16; ++i)
          for (int j = 0; j < 16; ++j) {
            const auto s =
                lobe.sample(wo, (static_cast<float>(k) + 0.5f) / 64,
                            {(static_cast<float>(i) + 0.5f) / 16, (static_cast<float>(j) + 0.5f) / 16});
            if (s) sum += s->weight.g * (1 + 0.5 * std::sin(3 * s->wi.x) + 0.3 * s->wi.y * s->wi.z);
          }
      return sum / (64 * 16 * 16);
    };
    EXPECT_NEAR(seen(rough), seen(smooth), 0.01) << "cos " << c;
    worst = std::max(worst, std::abs(seen(rough) - seen(smooth)));
  }
  record({"Lobes", "glass jumps where its roughness goes over into the smooth interface",
          "≤ 0.01 of a smooth field", fmt::format("{:.1e}", worst), "pbrt-v3 #214"});
}

}  // namespace
}  // namespace umbral
