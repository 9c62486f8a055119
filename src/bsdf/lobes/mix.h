// Two lobes on one surface, each on a share of it that is too fine to be seen: rust on steel, dust on paint.
#pragma once

#include <tuple>

#include "bsdf/bsdf.h"
#include "bsdf/interfaces/absorption.h"
#include "bsdf/lobe_list.h"
#include "bsdf/lobe_parts.h"
#include "core/parameters.h"

namespace umbral {

// f = (1 − w) f_a + w f_b, so that no light is gained or lost that a and b do not gain or lose. One of the two is drawn, b
// with the probability w, and its direction is weighed by the densities of both; no weight is larger than theirs.
//
// `a` and `b` outlive it. Of the two at most one kind of inside may be entered by refraction: what lies behind the surface
// is that of `a`, if it has one, else that of `b`.
struct Mix {
  const Lobes* a = nullptr;
  const Lobes* b = nullptr;
  float amount = 0.5f;

  static constexpr const char* kind = "mix";
  static constexpr const char* doc = "two materials in one surface, by weight: rust on steel, dust on paint";
  static constexpr auto parameters = std::tuple{
      required<&Mix::a>("a", "the material that an amount of 0 shows alone"),
      required<&Mix::b>("b", "the material that an amount of 1 shows alone; may be a mix again"),
      parameter<&Mix::amount>("amount", "w of f = (1 − w) f_a + w f_b: the share of b", zero_to_one)};

  bool only_delta() const;
  static constexpr bool has_choice() { return true; }
  bool transmits() const;

  Spectrum f_cos(const Vec3& wo, const Vec3& wi) const;
  void each_part(const Vec3& wo, const Vec3& wi, PartVisit visit) const;
  float pdf(const Vec3& wo, const Vec3& wi) const;
  std::optional<BsdfSample> sample(const Vec3& wo, float u1, const Vec2& u2) const;
  Spectrum albedo() const;
  BlinnPhongCoefficients local_model() const;
  std::optional<Absorption> interior() const;
};

}  // namespace umbral
