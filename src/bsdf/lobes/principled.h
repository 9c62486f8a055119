// The material of glTF 2.0 with its physical extensions: metal, plastic, glass, cloth and lacquer in one set of parameters.
#pragma once

#include <tuple>

#include "bsdf/bsdf.h"
#include "bsdf/common_parameters.h"
#include "bsdf/interfaces/absorption.h"
#include "bsdf/lobe_parts.h"
#include "core/parameters.h"

namespace umbral {

// A mixture under two layers [Khronos 2021; appendix B and the KHR_materials extensions]:
//   f = clearcoat layer + (1 − c R) (sheen layer + (1 − s E) (m metal + (1 − m) ((1 − t) opaque + t clear))).
// Metal is a Conductor, opaque a Gloss, clear a Dielectric, or a Pane where the wall is thin, each of which keeps its
// energy. What stands there for (1 − c R) and (1 − s E), so that f is reciprocal: bsdf/lobes/principled_layers.h.
// The clear coat may lean on all the rest: then each is evaluated, with its |cos θi|, about its own normal.
//
// Where glTF leaves a choice: F is Fresnel's, for which Schlick's approximation stands there; iridescence is
// [Belcour and Barla 2017]; anisotropy stretches what is seen through the surface as it does reflections.
struct Principled {
  Spectrum base_color = white;
  float metallic = 0;  // glTF's own default is 1: its reader says so
  float roughness = 0.5f;
  float ior = 1.5f;
  float specular = 1;
  Spectrum specular_color = white;
  float transmission = 0;
  bool thin_walled = false;
  Spectrum attenuation_color = white;
  float attenuation_distance = infinity;
  float clearcoat = 0;
  float clearcoat_roughness = 0;
  Spectrum sheen_color = black;
  float sheen_roughness = 0;
  float anisotropy = 0;
  float anisotropy_rotation = 0;
  float iridescence = 0;
  float iridescence_ior = 1.3f;
  float iridescence_thickness = 400;

  // Of the clearcoat, in the frame whose z is the normal of all the rest; unit. No parameter: a surface tells it.
  Vec3 clearcoat_normal{0, 0, 1};

  static constexpr const char* kind = "principled";
  static constexpr const char* doc =
      "glTF's metallic-roughness with its physical extensions; closed where it transmits, unless thin_walled";
  static constexpr auto parameters = std::tuple_cat(
      std::tuple{
          parameter<&Principled::base_color>(
              "base_color", "colour of the metal, the body or what shines through", zero_to_one),
          parameter<&Principled::metallic>("metallic", "share of metal; the rest is dielectric", zero_to_one),
          parameter<&Principled::roughness>("roughness", "square root of GGX's alpha; 0 is polished",
                                            zero_to_one),
          parameter<&Principled::ior>("ior", "index of refraction of the dielectric", Range{1, 10}),
          parameter<&Principled::specular>("specular", "strength of the dielectric's reflection",
                                           zero_to_one),
          parameter<&Principled::specular_color>("specular_color", "tint of it at normal incidence",
                                                 Range{0, 1e6f}),
          parameter<&Principled::transmission>("transmission", "share of the dielectric's body that is clear",
                                               zero_to_one),
          parameter<&Principled::thin_walled>("thin_walled",
                                              "what shines through goes straight on; else it is refracted")},
      detail::attenuation_parameters<Principled>(),
      std::tuple{
          parameter<&Principled::clearcoat>("clearcoat", "strength of a clear layer of index 1.5",
                                            zero_to_one),
          parameter<&Principled::clearcoat_roughness>("clearcoat_roughness", "of that layer", zero_to_one),
          parameter<&Principled::sheen_color>("sheen_color", "of fuzz on the surface", zero_to_one),
          parameter<&Principled::sheen_roughness>("sheen_roughness",
                                                  "of that fuzz: low is velvet at its edges", zero_to_one)},
      detail::anisotropy_parameters<Principled>("how far highlights stretch along u, as in glTF"),
      std::tuple{
          parameter<&Principled::iridescence>("iridescence", "share of the surface under a thin film",
                                              zero_to_one),
          parameter<&Principled::iridescence_ior>("iridescence_ior", "index of that film", Range{1, 10}),
          parameter<&Principled::iridescence_thickness>("iridescence_thickness", "of that film, nm",
                                                        Range{0, 1e4f})});

  bool transmits() const { return transmission > 0 && metallic < 1; }

  bool only_delta() const;
  static constexpr bool has_choice() { return true; }
  bool follows_tangent() const { return anisotropy != 0; }

  Spectrum f_cos(const Vec3& wo, const Vec3& wi) const;
  void each_part(const Vec3& wo, const Vec3& wi, PartVisit visit) const;
  float pdf(const Vec3& wo, const Vec3& wi) const;
  std::optional<BsdfSample> sample(const Vec3& wo, float u1, const Vec2& u2) const;
  Spectrum albedo() const;
  BlinnPhongCoefficients local_model() const;

  // Whether it has an inside, which light enters by refraction, and the index there.
  bool has_inside() const { return transmits() && !thin_walled; }
  float interior_eta() const { return has_inside() ? ior : 1; }
  std::optional<Absorption> interior() const {
    if (!has_inside()) return std::nullopt;
    return Absorption::of_color(attenuation_color, attenuation_distance);
  }
};

}  // namespace umbral
