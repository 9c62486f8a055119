// The closed list of lobes: their names, and what is asked of any of them.
#include <set>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "bsdf/lobes.h"
#include "core/kinds.h"
#include "lobe_examples.h"

namespace umbral {
namespace {

using namespace test;

struct ParameterChecker {
  std::set<std::string>& names;
  void operator()(const ParameterInfo& info, const Lobes*) {
    EXPECT_TRUE(names.insert(info.name).second) << info.name;
  }
  void operator()(const ParameterInfo& info, bool) {
    EXPECT_TRUE(names.insert(info.name).second) << info.name;
  }
  void operator()(const ParameterInfo& info, float value) {
    EXPECT_TRUE(names.insert(info.name).second) << info.name;
    EXPECT_TRUE(info.range.contains(value)) << info.name;
  }
  template <class E>
    requires std::is_enum_v<E>
  void operator()(const ParameterInfo& info, E value) {
    EXPECT_TRUE(names.insert(info.name).second) << info.name;
    EXPECT_LT(static_cast<std::size_t>(value), EnumNames<E>::names.size());
  }
  void operator()(const ParameterInfo& info, const Spectrum& value) {
    EXPECT_TRUE(names.insert(info.name).second) << info.name;
    for (int c = 0; c < 3; ++c) EXPECT_TRUE(info.range.contains(value[c])) << info.name;
  }
};

TEST(Lobes, DescribeEachParameterOnceAndStartWithinItsRange) {
  for_each_kind<Lobes>([](const auto& lobe) {
    SCOPED_TRACE(lobe.kind);
    std::set<std::string> names;
    for_each_parameter(lobe, ParameterChecker{names});
    EXPECT_FALSE(names.empty());
  });
}

TEST(Lobes, LetLightThroughWhereTheirParametersSay) {
  Principled principled;
  EXPECT_FALSE(transmits(principled));
  principled.transmission = 1e-3f;
  EXPECT_TRUE(transmits(principled));
  principled.thin_walled = true;
  EXPECT_TRUE(transmits(principled));
  principled.metallic = 1;
  EXPECT_FALSE(transmits(principled)) << "metal is opaque";
  EXPECT_TRUE(transmits(Dielectric{}) && transmits(ThinDielectric{}) && transmits(DiffuseTransmission{}));
  EXPECT_FALSE(transmits(Lambert{}) || transmits(Mirror{}) || transmits(Plastic{}));
}

TEST(Lobes, HaveNamesOfTheirOwnByWhichTheyAreMade) {
  const std::vector<std::string> kinds = kind_names<Lobes>();
  EXPECT_EQ(kinds.size(), std::variant_size_v<Lobes>);
  EXPECT_EQ(std::set<std::string>(kinds.begin(), kinds.end()).size(), kinds.size());
  for (std::size_t i = 0; i < kinds.size(); ++i) {
    const auto lobe = make_kind<Lobes>(kinds[i]);
    ASSERT_TRUE(lobe) << kinds[i];
    EXPECT_EQ(lobe->index(), i);
  }
  EXPECT_FALSE(make_kind<Lobes>("mate"));
}

TEST(Lobes, PassOnWhatTheirAlternativesDo) {
  const BlinnPhong lobe{rgb(0.2f, 0.3f, 0.4f), rgb(0.5f, 0.4f, 0.3f), 50};
  const Lobes lobes = lobe;
  const Vec3 wo = direction_at(0.7, 1), wi = direction_at(0.6, 4);
  EXPECT_EQ(f_cos(lobes, wo, wi), lobe.f_cos(wo, wi));
  EXPECT_EQ(pdf(lobes, wo, wi), lobe.pdf(wo, wi));
  EXPECT_EQ(sample(lobes, wo, 0.9f, {0.3f, 0.6f})->wi, lobe.sample(wo, 0.9f, {0.3f, 0.6f})->wi);
  EXPECT_EQ(albedo(lobes), lobe.albedo());
  EXPECT_EQ(to_blinn_phong(lobes).ks, lobe.ks);
  EXPECT_FALSE(only_delta(lobes));
  EXPECT_TRUE(has_choice(lobes));
  EXPECT_TRUE(only_delta(Lobes{Mirror{}}));
  EXPECT_FALSE(has_choice(Lobes{Lambert{}}));
}

}  // namespace
}  // namespace umbral
