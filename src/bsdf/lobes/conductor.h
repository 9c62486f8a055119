// Metals, smooth and rough.
#pragma once

#include <tuple>

#include "bsdf/bsdf.h"
#include "bsdf/common_parameters.h"
#include "bsdf/facets/microfacet.h"
#include "bsdf/interfaces/metals.h"
#include "bsdf/lobe_parts.h"

namespace umbral {

// f = F D G₂/(4 cos θo cos θi) [Cook and Torrance 1982; Walter et al. 2007], plus the light that leaves after more than
// one bounce between the facets [Kulla and Conty 2017], so that a surface with F = 1 loses nothing:
//   f_ms = (1 − E(wo))(1 − E(wi)) / (π (1 − E_avg)) · F_avg² E_avg / (1 − F_avg (1 − E_avg)),
// E being what one bounce keeps (bsdf/facets/microfacet_albedo.h). F is that of a complex index, if there is one, else
// Schlick's with a tint towards the edge. Below alpha = 0.001 it is a mirror.
struct Conductor {
  Metal metal = Metal::none;
  Spectrum reflectance = grey(0.9f);
  Spectrum edge_tint = grey(1.0f);
  Spectrum eta = black;
  Spectrum k = black;
  float roughness = 0.2f;
  float film_eta = 1.3f;
  float film_thickness = 0;
  float film_share = 1;  // the part of it that the film is on; no parameter of this kind
  float anisotropy = 0;
  float anisotropy_rotation = 0;

  static constexpr const char* kind = "conductor";
  static constexpr const char* doc = "a metal, polished or rough (GGX); by its name, complex index or colour";
  static constexpr auto parameters = std::tuple_cat(
      std::tuple{
          parameter<&Conductor::metal>("metal", "its complex index by chemical symbol, instead of eta and k"),
          parameter<&Conductor::reflectance>(
              "reflectance", "colour seen at normal incidence, where there is no index", zero_to_one),
          parameter<&Conductor::edge_tint>("edge_tint", "tint of that reflectance at 82°", zero_to_one),
          parameter<&Conductor::eta>("eta", "real part of the index; with k, instead of the reflectance",
                                     Range{0, 100}),
          parameter<&Conductor::k>("k", "imaginary part of the index", Range{0, 100}),
          parameter<&Conductor::roughness>("roughness", "square root of GGX's alpha; 0 is a mirror",
                                           zero_to_one)},
      detail::anisotropy_parameters<Conductor>(detail::facet_anisotropy),
      detail::film_parameters<Conductor>("index of a thin film on it, as oxide on steel"));

  bool only_delta() const { return sqr(roughness) < Ggx::smallest_alpha; }
  bool has_choice() const { return !only_delta(); }
  bool follows_tangent() const { return anisotropy != 0; }

  Spectrum f_cos(const Vec3& wo, const Vec3& wi) const;
  float pdf(const Vec3& wo, const Vec3& wi) const;
  std::optional<BsdfSample> sample(const Vec3& wo, float u1, const Vec2& u2) const;
  Spread spread() const;
  Spectrum albedo() const { return fresnel(1); }
  BlinnPhongCoefficients local_model() const;

  // Share of the light that one facet reflects, and its mean over the hemisphere.
  Spectrum fresnel(float cos_theta) const;
  Spectrum fresnel_average() const;
};

}  // namespace umbral
