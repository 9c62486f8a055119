// Matte surfaces: the same radiance in every direction [Lambert 1760].
#pragma once

#include <tuple>

#include "bsdf/bsdf.h"
#include "bsdf/lobe_parts.h"
#include "core/parameters.h"
#include "core/warp.h"

namespace umbral {

// f = ρ/π.
struct Lambert {
  Spectrum reflectance = grey(0.5f);

  static constexpr const char* kind = "matte";
  static constexpr const char* doc = "an ideally diffuse surface (Lambert)";
  static constexpr bool only_delta() { return false; }
  static constexpr bool has_choice() { return false; }
  static constexpr auto parameters = std::tuple{
      parameter<&Lambert::reflectance>("reflectance", "share of the light that is reflected", zero_to_one)};

  Spectrum f_cos(const Vec3& wo, const Vec3& wi) const {
    return same_side(wo, wi) ? reflectance * (inverse_pi * std::abs(wi.z)) : black;
  }

  float pdf(const Vec3& wo, const Vec3& wi) const {
    return same_side(wo, wi) ? cosine_hemisphere_pdf(std::abs(wi.z)) : 0.0f;
  }

  std::optional<BsdfSample> sample(const Vec3& wo, float, const Vec2& u2) const {
    std::optional<BsdfSample> result;  // built in place: a copy of what was just stored would stall
    const Vec3 wi = on_side_of(square_to_cosine_hemisphere(u2), wo);
    if (!same_side(wo, wi)) return result;
    result.emplace();
    result->wi = wi;
    result->weight = reflectance;
    result->pdf = cosine_hemisphere_pdf(std::abs(wi.z));
    return result;
  }

  static Spread spread() { return Spread::matte(); }

  Spectrum albedo() const { return reflectance; }

  BlinnPhongCoefficients local_model() const { return {reflectance, reflectance, black, 1}; }
};

}  // namespace umbral
