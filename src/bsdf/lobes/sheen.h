// Cloth, dust and velvet: a matte body under fuzz.
#pragma once

#include <tuple>

#include "bsdf/bsdf.h"
#include "bsdf/lobe_parts.h"
#include "core/parameters.h"

namespace umbral {

// The fuzz of bsdf/layers/fuzz.h in its colour s, and of what it leaves the matte body:
//   f_d = ρ (1 − s E(wo)) (1 − s E(wi))/(π (1 − s E_avg)) [after Kelemen and Szirmay-Kalos 2001].
struct Sheen {
  Spectrum reflectance = grey(0.2f);
  Spectrum sheen_color = white;
  float sheen_roughness = 0.4f;

  static constexpr const char* kind = "sheen";
  static constexpr const char* doc = "cloth, velvet, dust: a matte body under fuzz that shines at its edges";
  static constexpr auto parameters = std::tuple{
      parameter<&Sheen::reflectance>("reflectance", "colour of the body beneath the fuzz", zero_to_one),
      parameter<&Sheen::sheen_color>("sheen_color", "of the fuzz", zero_to_one),
      parameter<&Sheen::sheen_roughness>("sheen_roughness", "of the fuzz: low shines at the edges alone",
                                         zero_to_one)};

  static constexpr bool only_delta() { return false; }
  static constexpr bool has_choice() { return true; }

  Spectrum f_cos(const Vec3& wo, const Vec3& wi) const;
  void each_part(const Vec3& wo, const Vec3& wi, PartVisit visit) const;
  float pdf(const Vec3& wo, const Vec3& wi) const;
  std::optional<BsdfSample> sample(const Vec3& wo, float u1, const Vec2& u2) const;
  Spectrum albedo() const;
  BlinnPhongCoefficients local_model() const;
};

}  // namespace umbral
