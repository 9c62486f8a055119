// Fresnel's equations against the textbook's amplitudes in long double, and Snell's law.
#include "bsdf/interfaces/fresnel.h"

#include <array>

#include <gtest/gtest.h>

#include "lobe_examples.h"
#include "support/quadrature.h"
#include "support/stability.h"

namespace umbral {
namespace {

using namespace test;

// Mean of the squared amplitudes of both polarisations. The differences are expanded by the squares so that nothing
// cancels: r_s = (c − ηt)/(c + ηt) = (c² − η²t²)/(c + ηt)², η²t² = η² − 1 + c², likewise r_p.
long double reference(float cos_i, float eta_float) {
  const long double c = cos_i, eta = eta_float, eta2 = eta * eta;
  const long double eta2_t2 = (eta - 1) * (eta + 1) + c * c;
  if (eta2_t2 <= 0) return 1;
  const long double eta_t = std::sqrt(eta2_t2);  // η cos θt
  const long double rs = (1 - eta) * (1 + eta) / ((c + eta_t) * (c + eta_t));
  // η⁴c² − η²t² = (η² − 1)(η²c² + c² − 1)
  const long double rp =
      (eta - 1) * (eta + 1) * (eta2 * c * c + c * c - 1) / ((eta2 * c + eta_t) * (eta2 * c + eta_t));
  return (rs * rs + rp * rp) / 2;
}

double average(float eta) {
  // Halves of both sides of the critical cosine, where there is one, so that the rule meets no kink.
  const double kink = eta < 1 ? std::sqrt(1 - sqr(static_cast<double>(eta))) : 0;
  const auto f = [&](double c) {
    return 2 * c * static_cast<double>(fresnel_dielectric(static_cast<float>(c), eta));
  };
  // c = kink + (1 − kink) s² takes the root at the kink away.
  return sqr(kink) +
         integral<64>(0, 1, [&](double s) { return f(kink + (1 - kink) * s * s) * 2 * s * (1 - kink); });
}

TEST(Fresnel, AgreesWithTheAmplitudesAtAnyAngle) {
  Random random(1);
  for (const float eta :
       {1.000001f, 1.00001f, 1.001f, 1.1f, 1.33f, 1.5f, 2.4f, 10.0f, 1 / 1.001f, 1 / 1.5f, 0.1f})
    for (int i = 0; i < 2000; ++i) {
      const auto c = static_cast<float>(i % 2 == 0 ? random.between(0, 1) : random.log_between(1e-6, 1));
      const long double expected = reference(c, eta);
      // Near the critical angle the square root magnifies the rounding of the cosine itself.
      const long double g2 =
          (static_cast<long double>(eta) - 1) * (eta + 1.0L) + static_cast<long double>(c) * c;
      if (std::abs(g2) < 1e-4L * c * c) continue;
      EXPECT_NEAR(fresnel_dielectric(c, eta), static_cast<double>(expected),
                  static_cast<double>(4e-6L * expected) + 1e-20)
          << "cos " << c << ", eta " << eta;
    }
}

// The hard row of the table: the relative error of the naive form is 13 % at eta − 1 = 1e-6.
TEST(Fresnel, KeepsItsDigitsAsMediaBecomeAlike) {
  double worst = 0;
  for (const float gap : {1e-3f, 1e-5f, 1e-6f, 3e-7f}) {
    const float eta = 1 + gap;
    for (const float c : {1.0f, 0.9f, 0.5f, 0.1f, 0.01f}) {
      const auto expected = static_cast<double>(reference(c, eta));
      worst = std::max(worst, std::abs(fresnel_dielectric(c, eta) / expected - 1));
    }
  }
  EXPECT_LE(worst, 2e-6);
  record({"Lobes", "Fresnel's reflectance loses digits as η → 1, down to 1 + 3e-7", "≤ 2e-6 relative",
          fmt::format("{:.1e}", worst), "the common form: 0.13 at 1 + 1e-6"});
  EXPECT_EQ(fresnel_dielectric(0.5f, 1), 0);
  EXPECT_EQ(fresnel_dielectric(1, 1), 0);
}

TEST(Fresnel, HasItsKnownValues) {
  EXPECT_NEAR(fresnel_dielectric(1, 1.5f), 0.04, 1e-8);
  EXPECT_NEAR(fresnel_dielectric(1, 1 / 1.5f), 0.04, 1e-7);
  EXPECT_EQ(fresnel_dielectric(0, 1.5f), 1);
  EXPECT_NEAR(fresnel_dielectric(1, 1.33f), sqr(0.33 / 2.33), 1e-8);
  // At Brewster's angle, tan θ = η, only one polarisation is reflected: F = ((η² − 1)/(η² + 1))²/2.
  EXPECT_NEAR(fresnel_dielectric(1 / std::sqrt(1 + 1.5f * 1.5f), 1.5f), sqr(1.25 / 3.25) / 2, 1e-7);
  // A slab reflects between its two faces without end: T = (1 − R)/(1 + R), 12/13 at normal incidence.
  const double r = fresnel_dielectric(1, 1.5f);
  EXPECT_NEAR((1 - r) / (1 + r), 12.0 / 13.0, 1e-7);
}

TEST(Fresnel, HasTheKnownAveragesOverTheHemisphere) {
  EXPECT_NEAR(average(1.33f), 0.0659308, 2e-7);
  EXPECT_NEAR(average(1.5f), 0.0917780, 2e-7);
  EXPECT_NEAR(average(2.4f), 0.2101813, 2e-7);
  EXPECT_NEAR(average(1 / 1.5f), 0.5963458, 2e-6);
  for (const float eta : {1.05f, 1.33f, 2.0f, 2.4f})
    EXPECT_NEAR(average(1 / eta), 1 - (1 - average(eta)) / sqr(static_cast<double>(eta)), 1e-5) << eta;
}

TEST(Fresnel, IsTheSameFromBothSidesAlongOnePath) {
  for (const float eta : {1.1f, 1.5f, 2.4f})
    for (const double c : {1.0, 0.8, 0.4, 0.1, 0.01}) {
      const auto below = refracted(direction_at(c, 1), eta);
      ASSERT_TRUE(below);
      // Towards the horizon the cosine within is told from that of the critical angle by its last digits only.
      EXPECT_NEAR(fresnel_dielectric(-below->z, 1 / eta), fresnel_dielectric(static_cast<float>(c), eta),
                  1e-6 / c);
    }
}

TEST(Fresnel, ReflectsAllBeyondTheCriticalAngle) {
  for (const float eta : {1 / 1.001f, 1 / 1.33f, 1 / 1.5f, 0.1f}) {
    const double critical = std::sqrt(1 - sqr(static_cast<double>(eta)));
    for (const double share : {0.0, 0.5, 0.99, 0.9999})
      EXPECT_EQ(fresnel_dielectric(static_cast<float>(critical * share), eta), 1);
    EXPECT_LT(fresnel_dielectric(static_cast<float>(critical + 1e-3 * (1 - critical)), eta), 1);
    EXPECT_FALSE(refracted(direction_at(critical * 0.999, 2), eta));
    EXPECT_TRUE(refracted(direction_at(critical + 1e-3 * (1 - critical), 2), eta));
  }
}

TEST(Refraction, FollowsSnellsLaw) {
  Random random(2);
  for (int i = 0; i < 10'000; ++i) {
    Vec3 w(random.direction());
    w.z = std::abs(w.z);
    const auto eta = static_cast<float>(random.log_between(0.1, 10));
    const auto down = refracted(w, eta);
    const double sine_in = std::hypot(static_cast<double>(w.x), static_cast<double>(w.y));
    if (!down) {
      EXPECT_GT(sine_in, eta * (1 - 1e-6));
      continue;
    }
    EXPECT_LT(down->z, 0);
    EXPECT_NEAR(glm::length(*down), 1, 1e-6);
    const double sine_out = std::hypot(static_cast<double>(down->x), static_cast<double>(down->y));
    EXPECT_NEAR(sine_in, eta * sine_out, 1e-6 * sine_in);
    // In the plane of incidence, on the other side of the normal.
    EXPECT_LE(down->x * w.x + down->y * w.y, 0);
    EXPECT_NEAR(down->x * w.y - down->y * w.x, 0, 1e-6);
  }
}

TEST(Refraction, ComesBackTheWayItWent) {
  for (const float eta : {1.0f, 1.2f, 1.5f, 3.0f})
    for (const double c : {1.0, 0.7, 0.3, 0.05}) {
      const Vec3 w = direction_at(c, 0.7);
      const auto down = refracted(w, eta);
      ASSERT_TRUE(down);
      const auto up = refracted(flipped(*down), 1 / eta);
      ASSERT_TRUE(up);
      EXPECT_NEAR(glm::length(flipped(*up) - w), 0, 2e-5);
    }
}

}  // namespace
}  // namespace umbral
