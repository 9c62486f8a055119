// Coloured diffuse bodies under a clear dielectric skin: plastic, glazed pottery, varnished wood.
#pragma once

#include <tuple>

#include "bsdf/bsdf.h"
#include "bsdf/facets/microfacet.h"
#include "bsdf/lobe_parts.h"
#include "core/parameters.h"

namespace umbral {

// What the skin reflects, smooth or of GGX facets, and what gets through it twice with a diffuse body of reflectance ρ in
// between [after Kelemen and Szirmay-Kalos 2001]:
//   f_d = (1 − R(wo)) (1 − R(wi)) / (π (1 − R_avg)) · ρ (1 − K)/(1 − ρ K).
// R is the share that the skin reflects from outside (bsdf/facets/microfacet_albedo.h) and K = 1 − (1 − R_avg)/eta² what it
// reflects back into the body [Judd 1942]; the last factor sums the bounces between both, which deepen the colour.
// With ρ = 1 nothing is lost at any roughness.
struct Plastic {
  Spectrum reflectance = grey(0.5f);
  float eta = 1.5f;
  float roughness = 0.1f;

  static constexpr const char* kind = "plastic";
  static constexpr const char* doc = "a diffuse colour under a clear skin: plastic, glaze, varnish";
  static constexpr auto parameters = std::tuple{
      parameter<&Plastic::reflectance>("reflectance", "colour of the body beneath the skin", zero_to_one),
      parameter<&Plastic::eta>("eta", "index of refraction of the skin", Range{1, 10}),
      parameter<&Plastic::roughness>("roughness", "of the skin, square root of GGX's alpha; 0 is polished",
                                     zero_to_one)};

  static constexpr bool only_delta() { return false; }
  static constexpr bool has_choice() { return true; }

  Spectrum f_cos(const Vec3& wo, const Vec3& wi) const;
  void each_part(const Vec3& wo, const Vec3& wi, PartVisit visit) const;
  float pdf(const Vec3& wo, const Vec3& wi) const;
  std::optional<BsdfSample> sample(const Vec3& wo, float u1, const Vec2& u2) const;
  Spectrum albedo() const;
  float internal_reflectance() const;  // K: share of the light from the body that the skin sends back
  BlinnPhongCoefficients local_model() const;
};

}  // namespace umbral
