// Clear dielectrics, smooth and rough: glass, water, frosted glass.
#pragma once

#include <tuple>

#include "bsdf/bsdf.h"
#include "bsdf/common_parameters.h"
#include "bsdf/interfaces/absorption.h"
#include "bsdf/interfaces/interface.h"
#include "core/parameters.h"

namespace umbral {

// Reflects by Fresnel's equations and refracts the rest by Snell's law, at a smooth interface or at GGX facets
// [Walter et al. 2007]. The normal points out of the medium, so the surface must be closed. Radiance changes by 1/eta²
// on the way in and by eta² on the way out [Veach 1997, §5.2]; f and the weights hold that factor.
//
// A rough one loses the light that meets more than one facet. It is given back by two diffuse parts in which neither
// side gains: with M = 1 − E what one bounce loses (bsdf/facets/microfacet_albedo.h) and m its mean, on sides A and B,
//   f_AA = (1 − t_A) M_A(wo) M_A(wi)/(π m_A),  f_AB = t_A M_A M_B/(π m_B) for light from A to B
// [after Kulla and Conty 2017]; reciprocity asks for t_B m_B eta_B² = t_A m_A eta_A².
struct Dielectric {
  float eta = 1.5f;
  Spectrum reflectance = grey(1.0f);
  Spectrum transmittance = grey(1.0f);
  float roughness = 0;
  Spectrum attenuation_color = white;
  float attenuation_distance = infinity;
  float film_eta = 1.3f;
  float film_thickness = 0;
  float film_share = 1;  // this and the next two are glTF's; no parameters of this kind
  float specular = 1;
  Spectrum specular_color = white;
  float anisotropy = 0;
  float anisotropy_rotation = 0;

  static constexpr const char* kind = "dielectric";
  static constexpr const char* doc = "clear or frosted glass, or water; its surface must be closed";
  static constexpr auto parameters =
      std::tuple_cat(detail::clear_parameters<Dielectric>("index of refraction, inside over outside"),
                     std::tuple{parameter<&Dielectric::roughness>(
                         "roughness", "square root of GGX's alpha; 0 is smooth", zero_to_one)},
                     detail::anisotropy_parameters<Dielectric>(detail::facet_anisotropy),
                     detail::attenuation_parameters<Dielectric>(),
                     detail::film_parameters<Dielectric>("index of a thin film on it"));

  // Smooth, or so near to no interface at all that refraction spreads no wider than a smooth one's.
  bool only_delta() const;
  static constexpr bool has_choice() { return true; }
  bool follows_tangent() const { return anisotropy != 0; }

  Spectrum f_cos(const Vec3& wo, const Vec3& wi) const;
  float pdf(const Vec3& wo, const Vec3& wi) const;
  std::optional<BsdfSample> sample(const Vec3& wo, float u1, const Vec2& u2) const;
  Spectrum albedo() const { return transmittance; }

  static constexpr bool transmits() { return true; }

  // What is left of glass in a local model is its highlight, as strong as the reflection at normal incidence.
  BlinnPhongCoefficients local_model() const;

  float interior_eta() const { return eta; }
  std::optional<Absorption> interior() const {
    return Absorption::of_color(attenuation_color, attenuation_distance);
  }

  Interface interface() const {
    return {eta, specular, specular_color, {film_eta, film_thickness}, film_share};
  }
};

}  // namespace umbral
