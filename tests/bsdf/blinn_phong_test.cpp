// The energy-conserving Blinn-Phong lobe: its formula, its normalisation, and its digits at high exponents.
#include "bsdf/lobes/blinn_phong.h"

#include <gtest/gtest.h>

#include "lobe_examples.h"
#include "support/quadrature.h"

namespace umbral {
namespace {

using namespace test;

const Vec3 normal{0, 0, 1};

// N(n) in double [Giesen 2009].
double norm(double n) { return (n + 2) * (n + 4) / (8 * pi_d * (std::exp2(-n / 2) + n)); }

// What the specular part alone reflects of light from one direction, over half-vectors h, where the lobe is smooth:
// ∫ N cosⁿ θh cos θi dωi with dωi = 4 (wo·h) dωh, and x = cosⁿ⁺¹ θh, which is uniform under the peak.
double specular_albedo(double n, double cos_o) {
  const double sin_o = std::sqrt(1 - cos_o * cos_o);
  const auto over_azimuth = [&](double x) {
    const double log_cos = std::log(x) / (n + 1);
    const double c = std::exp(log_cos), s = std::sqrt(-std::expm1(2 * log_cos));
    return integral<64>(0, pi_d, [&](double phi) {
      const double o_h = sin_o * s * std::cos(phi) + cos_o * c;
      const double cos_i = 2 * o_h * c - cos_o;
      return o_h > 0 && cos_i > 0 ? 4 * o_h * cos_i : 0;
    });
  };
  double sum = 0;
  for (int i = 0; i < 64; ++i) sum += integral<16>(i / 64.0, (i + 1) / 64.0, over_azimuth);
  return 2 * norm(n) / (n + 1) * sum;
}

TEST(BlinnPhong, FollowsItsFormula) {
  Random random(1);
  for (int i = 0; i < 5000; ++i) {
    const auto n = static_cast<float>(random.log_between(0.1, 300));
    const BlinnPhong lobe{rgb(0.1f, 0.2f, 0.3f), rgb(0.6f, 0.5f, 0.7f), n};
    const Vec3d wo(Vec3(random.direction())), wi(Vec3(random.direction()));
    const Spectrum f_cos = lobe.f_cos(Vec3(wo), Vec3(wi));
    if (wo.z * wi.z <= 0) {
      EXPECT_TRUE(is_black(f_cos));
      continue;
    }
    const double n_h = std::abs(glm::normalize(wo + wi).z);
    for (int c = 0; c < 3; ++c) {
      const double f = lobe.kd[c] / pi_d + lobe.ks[c] * norm(n) * std::pow(n_h, n);
      EXPECT_NEAR(f_cos[c], f * std::abs(wi.z), 2e-5 * f_cos[c]);
    }
  }
}

// Where kd + ks passes 1, both are divided by the sum, channel by channel.
TEST(BlinnPhong, DividesCoefficientsThatSumToMoreThanOne) {
  const BlinnPhong loud{rgb(0.8f, 0.2f, 1.0f), rgb(0.8f, 0.3f, 1.0f), 20};
  const BlinnPhong fair{rgb(0.5f, 0.2f, 0.5f), rgb(0.5f, 0.3f, 0.5f), 20};
  const Vec3 wo = direction_at(0.7, 0), wi = direction_at(0.6, 3);
  for (int c = 0; c < 3; ++c) {
    EXPECT_NEAR(loud.f_cos(wo, wi)[c], fair.f_cos(wo, wi)[c], 1e-6);
    EXPECT_NEAR(loud.albedo()[c], fair.albedo()[c], 1e-6);
  }
  const BlinnPhongTerms terms = blinn_phong_f_cos(loud.local_model(), wo, wi);
  for (int c = 0; c < 4; ++c) EXPECT_FLOAT_EQ(terms.diffuse[c] + terms.specular[c], loud.f_cos(wo, wi)[c]);
  EXPECT_FLOAT_EQ(terms.diffuse.r, fair.kd.r * wi.z * inverse_pi);
}

TEST(BlinnPhong, ReflectsExactlyKsAtNormalIncidenceForEveryExponent) {
  for (int n = 0; n <= 500; ++n) EXPECT_NEAR(specular_albedo(n, 1), 1, 5e-6) << "exponent " << n;
  for (const double n : {1e3, 1e4, 1e5, 1e6}) EXPECT_NEAR(specular_albedo(n, 1), 1, 5e-6) << "exponent " << n;
  for (const float n : {0.0f, 0.5f, 1.0f, 32.0f, 500.0f, 1e6f})
    EXPECT_NEAR(blinn_phong_norm(n) / norm(n), 1, 1e-6) << n;
}

TEST(BlinnPhong, ReflectsNoMoreThanKsAtAnyAngle) {
  for (const double n : {0.0, 0.1, 0.5, 1.0, 2.0, 4.0, 9.0, 20.0, 50.0, 200.0, 1e3, 1e4, 1e6}) {
    double last = 0;
    for (const double c :
         {1e-4, 1e-3, 0.01, 0.05, 0.1, 0.2, 0.3, 0.4, 0.5, 0.6, 0.7, 0.8, 0.9, 0.95, 0.99, 1.0}) {
      const double albedo = specular_albedo(n, c);
      EXPECT_LE(albedo, 1 + 5e-6) << "exponent " << n << ", cos " << c;
      EXPECT_GE(albedo, last - 5e-6) << "exponent " << n << ", cos " << c << ": less away from the normal";
      last = albedo;
    }
  }
  EXPECT_NEAR(specular_albedo(0, 0.1), 1, 5e-6) << "with exponent 0 the lobe is Lambert's";
}

TEST(BlinnPhong, IsLambertWithExponentZero) {
  const BlinnPhong lobe{black, white, 0};
  const Vec3 wo = direction_at(0.3, 1), wi = direction_at(0.6, 3);
  EXPECT_NEAR(lobe.f_cos(wo, wi).g, wi.z * inverse_pi, 1e-7);
}

// The peak of exponent 10⁶ is 0.08° wide: the cosine there differs from 1 in its last digits only.
TEST(BlinnPhong, KeepsItsDigitsAtHighExponents) {
  Random random(2);
  for (const float n : {1e3f, 1e4f, 1e5f, 1e6f}) {
    const BlinnPhong lobe{black, white, n};
    for (int i = 0; i < 2000; ++i) {
      const Vec3 wo = direction_at(random.between(0.2, 1), random.between(0, 6));
      const auto sample = lobe.sample(wo, random.number(), random.square());
      if (!sample) continue;
      const glm::dvec3 sum = Vec3d(wo) + Vec3d(sample->wi);
      const double tan2 = (sum.x * sum.x + sum.y * sum.y) / (sum.z * sum.z);
      const double expected = norm(n) * std::exp(-0.5 * n * std::log1p(tan2)) * sample->wi.z;
      EXPECT_NEAR(lobe.f_cos(wo, sample->wi).g / expected, 1, 1e-3) << "exponent " << n;
    }
  }
}

// Half-vectors must fill the peak, not fall on the few rings that the digits of a cosine near 1 can tell apart.
TEST(BlinnPhong, DrawsManyDifferentAnglesAtHighExponents) {
  const BlinnPhong lobe{black, white, 1e6f};
  std::vector<float> radii;
  for (int i = 0; i < 10'000; ++i) {
    const auto sample = lobe.sample(normal, 0.5f, {(static_cast<float>(i) + 0.5f) / 10'000, 0});
    if (sample) radii.push_back(sample->wi.x);
  }
  std::sort(radii.begin(), radii.end());
  const auto distinct = std::unique(radii.begin(), radii.end()) - radii.begin();
  EXPECT_GT(distinct, 9000);
}

TEST(BlinnPhong, ChoosesTheBetterPartButNeverForgetsTheOther) {
  const Vec3 wo = direction_at(0.8, 1);
  const BlinnPhong only_diffuse{white, black, 100}, only_specular{black, white, 100},
      faint{white, grey(1e-6f), 100};
  const Vec3 mirror{-wo.x, -wo.y, wo.z};
  EXPECT_NEAR(only_diffuse.pdf(wo, mirror), mirror.z * inverse_pi, 1e-6);
  EXPECT_GT(faint.pdf(wo, mirror), 0.9f * mirror.z * inverse_pi + 0.5f);
  EXPECT_LT(only_specular.pdf(wo, direction_at(0.8, 1)), 1e-3f);
}

}  // namespace
}  // namespace umbral
