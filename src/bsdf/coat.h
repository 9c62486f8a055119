// Metal under a clear layer: lacquered brass, anodised aluminium, car paint.
#pragma once

#include <tuple>

#include "bsdf/bsdf.h"
#include "bsdf/conductor.h"
#include "core/parameters.h"

namespace umbral {

// f = f_skin + (1 − R) τ² f_metal: the skin of bsdf/skin.h reflects R, and what passes it twice is tinted by τ each time. R is
// the larger of what the skin reflects for both directions: so f is reciprocal, and no more leaves than arrives; up to 5 %
// is lost at grazing angles. The light refracted at the skin is not bent on its way to the metal.
struct Coat {
  float eta = 1.5f;
  float roughness = 0;
  Spectrum transmittance = white;
  Metal metal = Metal::none;
  Spectrum reflectance = grey(0.9f);
  float metal_roughness = 0.3f;

  static constexpr const char* kind = "coat";
  static constexpr const char* doc =
      "metal under a clear or tinted layer: lacquer, anodised aluminium, car paint";
  static constexpr auto parameters = std::tuple{
      parameter<&Coat::eta>("eta", "index of refraction of the layer", Range{1, 10}),
      parameter<&Coat::roughness>("roughness", "of the layer, square root of GGX's alpha; 0 is polished",
                                  zero_to_one),
      parameter<&Coat::transmittance>("transmittance", "what is left of light that passes the layer once",
                                      zero_to_one),
      parameter<&Coat::metal>("metal", "its complex index by chemical symbol, instead of the reflectance"),
      parameter<&Coat::reflectance>("reflectance", "colour of the metal at normal incidence", zero_to_one),
      parameter<&Coat::metal_roughness>("metal_roughness", "of the metal, as of the layer", zero_to_one)};

  bool only_delta() const;
  static constexpr bool has_choice() { return true; }

  Spectrum f_cos(const Vec3& wo, const Vec3& wi) const;
  float pdf(const Vec3& wo, const Vec3& wi) const;
  std::optional<BsdfSample> sample(const Vec3& wo, float u1, const Vec2& u2) const;
  Spectrum albedo() const;
  BlinnPhongCoefficients local_model() const;
};

}  // namespace umbral
