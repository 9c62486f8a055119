// Clear dielectrics, smooth and rough: glass, water, frosted glass.
#pragma once

#include <tuple>

#include "bsdf/absorption.h"
#include "bsdf/bsdf.h"
#include "bsdf/interface.h"
#include "core/parameters.h"

namespace umbral {

// Reflects by Fresnel's equations and refracts the rest by Snell's law, at a smooth interface or at GGX facets
// [Walter et al. 2007]. The normal points out of the medium, so the surface must be closed. Radiance changes by 1/eta²
// on the way in and by eta² on the way out [Veach 1997, §5.2]; f and the weights hold that factor.
//
// A rough one loses the light that meets more than one facet. It is given back by two diffuse parts in which neither
// side gains: with M = 1 − E what one bounce loses (bsdf/microfacet_albedo.h) and m its mean, on sides A and B,
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
  float film_share = 1;  // the last three are glTF's; no parameters of this kind
  float specular = 1;
  Spectrum specular_color = white;

  static constexpr const char* kind = "dielectric";
  static constexpr const char* doc = "clear or frosted glass, or water; its surface must be closed";
  static constexpr auto parameters = std::tuple{
      parameter<&Dielectric::eta>("eta", "index of refraction, inside over outside", Range{1, 10}),
      parameter<&Dielectric::reflectance>("reflectance", "tint of what is reflected", zero_to_one),
      parameter<&Dielectric::transmittance>("transmittance", "tint of what is refracted", zero_to_one),
      parameter<&Dielectric::roughness>("roughness", "square root of GGX's alpha; 0 is smooth", zero_to_one),
      parameter<&Dielectric::attenuation_color>(
          "attenuation_color", "what is left of white light inside after attenuation_distance", zero_to_one),
      parameter<&Dielectric::attenuation_distance>("attenuation_distance",
                                                   "world units; inf is a body that absorbs nothing",
                                                   Range{0, infinity, true, false}),
      parameter<&Dielectric::film_eta>("film_eta", "index of a thin film on it", Range{1, 10}),
      parameter<&Dielectric::film_thickness>("film_thickness", "of that film, nm; 0 is none",
                                             Range{0, 1e4f})};

  // Smooth, or so near to no interface at all that refraction spreads no wider than a smooth one's.
  bool only_delta() const;
  static constexpr bool has_choice() { return true; }

  Spectrum f_cos(const Vec3& wo, const Vec3& wi) const;
  float pdf(const Vec3& wo, const Vec3& wi) const;
  std::optional<BsdfSample> sample(const Vec3& wo, float u1, const Vec2& u2) const;
  Spectrum albedo() const { return transmittance; }

  static constexpr bool transmits = true;

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
