// Another lobe under a clear layer: lacquered brass, varnished wood, car paint.
#pragma once

#include <tuple>

#include "bsdf/bsdf.h"
#include "bsdf/lobe_list.h"
#include "bsdf/lobe_parts.h"
#include "core/parameters.h"

namespace umbral {

// f = f_skin + what the skin (bsdf/layers/skin.h) lets pass of each part of the lobe beneath (bsdf/layers/cover.h), which lets no light
// through and outlives it. A white lobe under a clear coat loses nothing; over a matte one this is Plastic.
struct Coat {
  const Lobes* base = nullptr;
  float eta = 1.5f;
  float roughness = 0;
  Spectrum transmittance = white;

  static constexpr const char* kind = "coat";
  static constexpr const char* doc =
      "another material under a clear or tinted layer: lacquer, varnish, car paint";
  static constexpr auto parameters =
      std::tuple{required<&Coat::base>("base", "the material beneath, any through which no light passes"),
                 parameter<&Coat::eta>("eta", "index of refraction of the layer", Range{1, 10}),
                 parameter<&Coat::roughness>(
                     "roughness", "of the layer, square root of GGX's alpha; 0 is polished", zero_to_one),
                 parameter<&Coat::transmittance>(
                     "transmittance", "what is left of light that passes the layer once", zero_to_one)};

  bool only_delta() const;
  static constexpr bool has_choice() { return true; }

  Spectrum f_cos(const Vec3& wo, const Vec3& wi) const;
  void each_part(const Vec3& wo, const Vec3& wi, PartVisit visit) const;
  float pdf(const Vec3& wo, const Vec3& wi) const;
  std::optional<BsdfSample> sample(const Vec3& wo, float u1, const Vec2& u2) const;
  Spectrum albedo() const;
  BlinnPhongCoefficients local_model() const;
};

}  // namespace umbral
