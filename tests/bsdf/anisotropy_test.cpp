// Lobes that are stretched along u: reflection and transmission, and what they keep of the light.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include "albedo_by_draws.h"
#include "bsdf/facets/albedo_quadrature.h"
#include "bsdf/facets/stretched_albedo.h"
#include "lobe_examples.h"

namespace umbral {
namespace {

using namespace test;

template <class Lobe>
Lobe rough(float roughness, float anisotropy, float rotation = 0) {
  Lobe lobe;
  lobe.roughness = roughness;
  lobe.anisotropy = anisotropy;
  lobe.anisotropy_rotation = rotation;
  return lobe;
}

struct Metal {
  static constexpr double z = 0.8;  // of the highlight's flank
  static Conductor make(float anisotropy, float rotation) {
    return rough<Conductor>(0.4f, anisotropy, rotation);
  }
};
struct PrincipledMetal {
  static constexpr double z = 0.8;
  static Principled make(float anisotropy, float rotation) {
    Principled lobe = rough<Principled>(0.3f, anisotropy, rotation);
    lobe.metallic = 1;
    return lobe;
  }
};
struct Glass {
  static constexpr double z = -0.97;
  static Dielectric make(float anisotropy, float rotation) {
    return rough<Dielectric>(0.4f, anisotropy, rotation);
  }
};
struct PrincipledGlass {
  static constexpr double z = -0.97;
  static Principled make(float anisotropy, float rotation) {
    Principled lobe = rough<Principled>(0.3f, anisotropy, rotation);
    lobe.transmission = 1;
    return lobe;
  }
};
struct PrincipledPane {
  static constexpr double z = -0.8;
  static Principled make(float anisotropy, float rotation) {
    Principled lobe = PrincipledGlass::make(anisotropy, rotation);
    lobe.thin_walled = true;
    return lobe;
  }
};

template <class>
class StretchedLobe : public testing::Test {};
using StretchedLobes = testing::Types<Metal, PrincipledMetal, Glass, PrincipledGlass, PrincipledPane>;
TYPED_TEST_SUITE(StretchedLobe, StretchedLobes);

// At the pole, half-vectors along the stretch lie in a wider highlight than those across it; a quarter turn swaps them.
TYPED_TEST(StretchedLobe, IsWiderAlongItsTurnedTangent) {
  const Vec3 wo{0, 0, 1}, along = direction_at(TypeParam::z, 0),
                          across = direction_at(TypeParam::z, pi_d / 2);
  const auto lobe = TypeParam::make(0.8f, 0);
  EXPECT_GT(lobe.f_cos(wo, along).g, 5 * lobe.f_cos(wo, across).g);
  EXPECT_NEAR(TypeParam::make(0.8f, 90).f_cos(wo, across).g, lobe.f_cos(wo, along).g,
              1e-4 * lobe.f_cos(wo, along).g);
  const auto turned = TypeParam::make(0.8f, 30);
  const double angle = 30 * pi_d / 180;
  EXPECT_GT(turned.f_cos(wo, direction_at(TypeParam::z, angle)).g,
            turned.f_cos(wo, direction_at(TypeParam::z, -angle)).g)
      << "counter-clockwise";
}

TYPED_TEST(StretchedLobe, IsRoundWithoutStretch) {
  const Vec3 wo{0, 0, 1};
  const auto lobe = TypeParam::make(0, 40);
  const float f = lobe.f_cos(wo, direction_at(TypeParam::z, 0.3)).g;
  EXPECT_NEAR(lobe.f_cos(wo, direction_at(TypeParam::z, 2)).g, f, 1e-5 * f);
}

struct Loss {
  float used;
  double bounce;
};

Loss loss_of(const Ggx& ggx, const Vec3& w, float eta) {
  const Vec3 above{w.x, w.y, std::abs(w.z)};
  return {stretched_interface_loss(ggx, w, eta),
          lattice_mean_over_normals<1597, 987>(ggx, above, [&](const Vec3& h) {
            return interface_bounce_at(ggx, above, h, w.z > 0 ? eta : 1 / eta).y;
          })};
}

TEST(StretchedInterface, LosesWhatItsTablesSay) {
  Random random(31);
  for (const float eta : {1.1f, 1.5f, 2.4f})
    for (int surface = 0; surface < 4; ++surface) {
      const float roughness = 0.1f + 0.9f * random.number(), anisotropy = 0.9f * random.number();
      const Ggx ggx = Ggx::of_roughness(roughness, surface == 0 ? 0.9f : anisotropy);
      for (int direction = 0; direction < 40; ++direction) {
        const Vec3 w = direction_at(2 * random.number() - 1, pi_d / 2 * random.number());
        const Loss loss = loss_of(ggx, w, eta);
        EXPECT_NEAR(loss.used, loss.bounce, w.z > 0 || eta > 1.4f ? 0.01 : 0.04)
            << fmt::format("eta {}, alpha {} {}, w {} {} {}", eta, ggx.alpha_x, ggx.alpha_y, w.x, w.y, w.z);
      }
    }
}

TEST(StretchedInterface, KnowsItsMeanLoss) {
  for (const float anisotropy : {0.3f, 0.9f}) {
    const Ggx ggx = Ggx::of_roughness(0.6f, anisotropy);
    const AverageLosses averages = stretched_interface_average_losses(ggx, 1.5f);
    for (const float side : {1.0f, -1.0f}) {
      constexpr int steps = 60;
      double sum = 0;
      for (int i = 0; i < steps; ++i)
        for (int j = 0; j < steps; ++j) {
          const double x = (i + 0.5) / steps, phi = (j + 0.5) / steps * pi_d / 2;
          sum += 4 * x * x * x * stretched_interface_loss(ggx, direction_at(side * x * x, phi), 1.5f);
        }
      EXPECT_NEAR((side > 0 ? averages.outside : averages.inside) / (sum / (steps * steps)), 1, 0.01);
    }
  }
}

template <class Lobe>
void expect_lossless(const Lobe& lobe, const Vec3& wo, const std::string& where) {
  const Albedo albedo = albedo_by_draws(lobe, wo, 9000);
  EXPECT_NEAR(albedo.mean, 1, 0.01 + 4 * albedo.error) << where;
  EXPECT_LT(albedo.error, 0.008) << where;
}

TEST(Dielectric, LosesNothingWhereItsFacetsAreStretched) {
  for (const float roughness : {0.2f, 0.5f, 0.9f})
    for (const float anisotropy : {0.01f, 0.3f, 0.9f})
      for (const double c : {1.0, 0.6, 0.2, -0.3, -0.8, -1.0})
        for (const double phi : {0.0, 0.8, 1.5})
          expect_lossless(
              rough<Dielectric>(roughness, anisotropy, 20), direction_at(c, phi),
              fmt::format("roughness {}, anisotropy {}, cos {}, phi {}", roughness, anisotropy, c, phi));
}

TEST(Principled, LosesNothingWhereItIsStretched) {
  for (const float transmission : {0.0f, 1.0f})
    for (const float roughness : {0.1f, 0.3f})
      for (const float anisotropy : {0.4f, 0.9f})
        for (const double c : {1.0, 0.5, 0.1, -0.2, -0.8})
          for (const double phi : {0.3, 1.5}) {
            Principled lobe = rough<Principled>(roughness, anisotropy);
            lobe.base_color = white;
            lobe.transmission = transmission;
            expect_lossless(lobe, direction_at(c, phi),
                            fmt::format("transmission {}, roughness {}, anisotropy {}, cos {}, phi {}",
                                        transmission, roughness, anisotropy, c, phi));
          }
}

}  // namespace
}  // namespace umbral
