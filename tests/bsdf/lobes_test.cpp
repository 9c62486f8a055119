// One suite over every lobe of the closed list: what the concept cannot say, each lobe must do.
#include "bsdf/lobes.h"

#include <array>
#include <cmath>

#include <gtest/gtest.h>

#include "lobe_draws.h"
#include "lobe_examples.h"
#include "lobe_text.h"

namespace umbral {
namespace {

using namespace test;

template <class>
struct TypesOf;
template <class... T>
struct TypesOf<std::variant<T...>> {
  using type = testing::Types<T...>;
};
struct KindNames {
  template <class T>
  static std::string GetName(int) {
    return T::kind;
  }
};

template <class Lobe>
class EveryLobe : public testing::Test {};
TYPED_TEST_SUITE(EveryLobe, TypesOf<Lobes>::type, KindNames);

// Lobes that are compensated by tables take longer to evaluate.
template <class Lobe>
constexpr int few = albedo_excess<Lobe> > 1e-4 ? 5 : 8;

// Outgoing directions from the normal to 0.06° above the horizon, on both sides.
const std::array directions{direction_at(1, 0),    direction_at(0.9, 1),   direction_at(-0.6, 2.5),
                            direction_at(0.25, 4), direction_at(-0.05, 6), direction_at(0.001, 5)};

// Numbers that a sampler gives, the two ends among them.
const std::array<float, 6> edge_numbers{0, 0x1p-32f, 0x1p-24f, 0.5f, 0.999f, one_minus_epsilon};

const std::array edge_directions{direction_at(1, 0),        direction_at(-1, 0),    direction_at(0.5, 2),
                                 direction_at(1e-4, 1),     direction_at(-1e-8, 3), direction_at(1e-18, 5),
                                 direction_at(-1e-30, 0.3), direction_at(1e-42, 4), Vec3{1, 0, 0.0f},
                                 Vec3{0.6f, -0.8f, 0.0f},   Vec3{-1, 0, -0.0f},     Vec3{0, 0, 1}};

template <class F>
double total_of(const SphereCells& cells, F&& f) {
  double total = 0;
  for (std::size_t i = 0; i < cells.size(); ++i) total += cells.integral_of(i, f);
  return total;
}

// What makes energy of radiance scattered from wi to wo: undoes its change between two media.
template <class Lobe>
float flux_scale(const Lobe& lobe, const Vec3& wo, const Vec3& wi) {
  if (same_side(wo, wi)) return 1;
  return sqr(wo.z > 0 ? inner_index(lobe) : 1 / inner_index(lobe));
}

TYPED_TEST(EveryLobe, DrawsDirectionsByItsDensity) {
  Random random(1);
  for (const TypeParam& lobe : lobe_examples<TypeParam>(few<TypeParam>))
    for (const Vec3& wo : directions) {
      SCOPED_TRACE(text_of(lobe, wo));
      constexpr int draws = 100'000;
      CountedDraws counted = counted_draws(lobe, wo, random, draws);
      double total = counted.total;
      // Where the density has a kink, a finer quadrature has the last word.
      if (total > 1 + 1e-5)
        total =
            total_of(cells_of(lobe, wo, random, 1 << 14), [&](const Vec3& wi) { return lobe.pdf(wo, wi); });
      EXPECT_LE(total, 1 + 1e-5);
      const ChiSquare chi = counted.chi_square(draws, total);
      EXPECT_GT(chi.p, 1e-5) << "chi² " << chi.statistic << " with " << chi.degrees << " degrees of freedom";
    }
}

TYPED_TEST(EveryLobe, SamplesAgreeWithEvaluation) {
  Random random(2);
  for (const TypeParam& lobe : lobe_examples<TypeParam>(40))
    for (const Vec3& wo : directions)
      for (int i = 0; i < 200; ++i) {
        const auto sample = draw(lobe, wo, random);
        if (!sample || sample->delta) continue;
        SCOPED_TRACE(text_of(lobe, wo));
        EXPECT_EQ(sample->pdf, lobe.pdf(wo, sample->wi));
        const Spectrum f_cos = lobe.f_cos(wo, sample->wi);
        for (int c = 0; c < 3; ++c) EXPECT_NEAR(sample->weight[c] * sample->pdf, f_cos[c], 1e-6 * f_cos[c]);
      }
}

TYPED_TEST(EveryLobe, IsReciprocal) {
  Random random(3);
  for (const TypeParam& lobe : lobe_examples<TypeParam>(40))
    for (int i = 0; i < 500; ++i) {
      const Vec3 a(random.direction());
      // Half of the pairs are drawn by the lobe, where its peak is.
      Vec3 b(random.direction());
      if (const auto sample = draw(lobe, a, random); sample && i % 2 == 0) b = sample->wi;
      if (std::abs(a.z) < 1e-3f || std::abs(b.z) < 1e-3f) continue;
      const auto scattered = [&](const Vec3& wo, const Vec3& wi) {
        const Spectrum f = lobe.f_cos(wo, wi) / std::abs(wi.z);
        return wo.z < 0 ? f / sqr(inner_index(lobe)) : f;
      };
      const Spectrum there = scattered(a, b), back = scattered(b, a);
      for (int c = 0; c < 3; ++c) EXPECT_NEAR(there[c], back[c], 2e-6 * there[c] + 1e-30) << text_of(lobe, a);
    }
}

// The mean weight of the draws is the albedo by quadrature, so that no part of f is out of the sampling's reach; and both
// with the mirror-like part are 1 at most. An error of 1e-4 + 5 standard errors (about 0.005) would be seen.
TYPED_TEST(EveryLobe, ReflectsWhatItsDrawsReachAndNoMoreThanArrives) {
  Random random(4);
  int channel = 0;
  for (const TypeParam& lobe : lobe_examples<TypeParam>(few<TypeParam>))
    for (const Vec3& wo : directions) {
      SCOPED_TRACE(text_of(lobe, wo));
      channel = (channel + 1) % 3;
      const double albedo = total_of(cells_of(lobe, wo, random), [&](const Vec3& wi) {
        return flux_scale(lobe, wo, wi) * lobe.f_cos(wo, wi)[channel];
      });
      constexpr int draws = 20'000;
      double sum = 0, squares = 0, mirrored = 0;
      for (int i = 0; i < draws; ++i) {
        const float u1 = (static_cast<float>(i) + random.number()) / draws;
        const auto sample = lobe.sample(wo, std::min(u1, one_minus_epsilon), random.square());
        if (!sample) continue;
        const double weight = flux_scale(lobe, wo, sample->wi) * sample->weight[channel];
        (sample->delta ? mirrored : sum) += weight;
        if (!sample->delta) squares += sqr(weight);
      }
      const double mean = sum / draws;
      const double error = std::sqrt(std::max(0.0, squares / draws - sqr(mean)) / draws);
      // As u1 is stratified, only a part that is drawn less than once may not have been drawn at all.
      EXPECT_NEAR(mean, albedo, 5 * error + 1e-4 * albedo + 1.0 / draws) << "channel " << channel;
      // The share of draws of a mirror-like part is right to one draw for each of its parts.
      const double excess = albedo_excess<TypeParam> + (mirrored > 0 ? 4.0 / draws : 0);
      EXPECT_LE(albedo + mirrored / draws, 1 + excess) << "channel " << channel;
    }
}

TYPED_TEST(EveryLobe, StaysFiniteAtTheEndsOfEveryRange) {
  for (const TypeParam& lobe : lobe_examples<TypeParam>(40))
    for (const Vec3& wo : edge_directions) {
      for (const Vec3& wi : edge_directions) {
        const Spectrum f_cos = lobe.f_cos(wo, wi);
        const float pdf = lobe.pdf(wo, wi);
        EXPECT_TRUE(is_finite(f_cos) && min_component(f_cos) >= 0)
            << text_of(lobe, wo) << ", z of wi = " << wi.z;
        EXPECT_TRUE(std::isfinite(pdf) && pdf >= 0) << text_of(lobe, wo) << ", z of wi = " << wi.z;
        if (wo.z * wi.z <= 0 && !umbral::transmits(lobe)) {
          EXPECT_EQ(pdf, 0);
          EXPECT_TRUE(is_black(f_cos));
        }
      }
      for (const float u1 : edge_numbers)
        for (const float x : edge_numbers)
          for (const float y : edge_numbers) {
            const auto sample = lobe.sample(wo, u1, {x, y});
            if (!sample) continue;
            EXPECT_NEAR(glm::length(sample->wi), 1, 1e-5) << text_of(lobe, wo);
            EXPECT_TRUE(is_finite(sample->weight) && min_component(sample->weight) >= 0)
                << text_of(lobe, wo) << ", u = " << u1 << ", " << x << ", " << y << ", weight "
                << sample->weight.r << " " << sample->weight.g << " " << sample->weight.b << ", pdf "
                << sample->pdf << ", wi.z " << sample->wi.z;
            EXPECT_TRUE(sample->delta || (std::isfinite(sample->pdf) && sample->pdf > 0))
                << text_of(lobe, wo);
          }
    }
}

TYPED_TEST(EveryLobe, IsTheSameFromBothSides) {
  if (std::is_same_v<TypeParam, Dielectric>) GTEST_SKIP() << "it always has an inside and an outside";
  Random random(6);
  for (const TypeParam& lobe : lobe_examples<TypeParam>(40)) {
    if (umbral::interior(lobe)) continue;
    for (const Vec3& wo : directions)
      for (int i = 0; i < 50; ++i) {
        const Vec3 wi(random.direction());
        EXPECT_EQ(lobe.f_cos(wo, wi), lobe.f_cos(flipped(wo), flipped(wi)));
        EXPECT_EQ(lobe.pdf(wo, wi), lobe.pdf(flipped(wo), flipped(wi)));
        const float u1 = random.number();
        const Vec2 u2 = random.square();
        const auto above = lobe.sample(wo, u1, u2), below = lobe.sample(flipped(wo), u1, u2);
        ASSERT_EQ(above.has_value(), below.has_value()) << text_of(lobe, wo);
        if (!above) continue;
        EXPECT_EQ(above->wi, flipped(below->wi));
        EXPECT_EQ(above->weight, below->weight);
        EXPECT_EQ(above->pdf, below->pdf);
        EXPECT_EQ(above->delta, below->delta);
      }
  }
}

TYPED_TEST(EveryLobe, TellsTheTruthAboutItsParts) {
  Random random(7);
  for (const TypeParam& lobe : lobe_examples<TypeParam>(20))
    for (const Vec3& wo : directions)
      for (int i = 0; i < 200; ++i) {
        const float u1 = random.number(), other = random.number();
        const Vec2 u2 = random.square();
        const auto sample = lobe.sample(wo, u1, u2);
        if (!lobe.has_choice()) {
          const auto same = lobe.sample(wo, other, u2);
          ASSERT_EQ(sample.has_value(), same.has_value());
          EXPECT_TRUE(!sample || sample->wi == same->wi) << "u1 is looked at";
        }
        if (!lobe.only_delta()) continue;
        const Vec3 wi = sample ? sample->wi : Vec3(random.direction());
        EXPECT_TRUE(!sample || sample->delta);
        EXPECT_TRUE(is_black(lobe.f_cos(wo, wi))) << "a mirror cannot be evaluated";
        EXPECT_EQ(lobe.pdf(wo, wi), 0);
      }
}

// Whatever says that it lets no light through draws no direction on the other side.
TYPED_TEST(EveryLobe, TellsWhetherLightMayPassThrough) {
  Random random(8);
  for (const TypeParam& lobe : lobe_examples<TypeParam>(40))
    for (int i = 0; i < 1000 && !umbral::transmits(lobe); ++i) {
      const Vec3 wo(random.direction());
      const auto sample = draw(lobe, wo, random);
      ASSERT_TRUE(!sample || same_side(wo, sample->wi)) << text_of(lobe, wo);
    }
}

TYPED_TEST(EveryLobe, HasAnAlbedoAndALocalModelWithinTheirRanges) {
  for (const TypeParam& lobe : lobe_examples<TypeParam>(100)) {
    const BlinnPhongCoefficients k = lobe.local_model();
    for (const Spectrum& s : {lobe.albedo(), k.ka, k.kd, k.ks}) {
      EXPECT_GE(min_component(s), 0);
      EXPECT_LE(max_component(s), 1 + 1e-6f);
    }
    EXPECT_TRUE(k.exponent >= 0 && k.exponent <= 1e6f) << k.exponent;
  }
}

}  // namespace
}  // namespace umbral
