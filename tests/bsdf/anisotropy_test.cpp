// Lobes that are stretched along u: reflection and transmission, and what they keep of the light.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include "albedo_by_draws.h"
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

// Glass is given back no more than it loses, and not all of it: standard errors are below 0.004.
TEST(Dielectric, MakesNothingWhereItsFacetsAreStretched) {
  for (const float roughness : {0.2f, 0.5f, 0.9f})
    for (const float anisotropy : {0.01f, 0.3f, 0.9f})
      for (const double c : {1.0, 0.6, 0.2, -0.3, -0.8, -1.0})
        for (const double phi : {0.0, 0.8, 1.5}) {
          const double albedo =
              albedo_by_draws(rough<Dielectric>(roughness, anisotropy, 20), direction_at(c, phi), 6000).mean;
          const std::string where =
              fmt::format("roughness {}, anisotropy {}, cos {}, phi {}", roughness, anisotropy, c, phi);
          EXPECT_LT(albedo, 1.02) << where;
          EXPECT_GT(albedo, anisotropy == 0.01f ? 0.97 : roughness == 0.2f ? 0.94 : 0.3) << where;
        }
}

}  // namespace
}  // namespace umbral
