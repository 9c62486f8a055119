// Opaque dielectrics as glTF means them: a diffuse colour, as it looks, under a skin that may be tinted.
#pragma once

#include "bsdf/layers/skin.h"
#include "bsdf/lobe_parts.h"

namespace umbral {

// Unlike Plastic's, its body has the colour that is seen: no bounces between skin and body deepen it.
struct Gloss {
  Spectrum reflectance;
  Skin skin;

  static constexpr bool only_delta() { return false; }

  Spectrum f_cos(const Vec3& wo, const Vec3& wi) const;
  void each_part(const Vec3& wo, const Vec3& wi, PartVisit visit) const;
  float pdf(const Vec3& wo, const Vec3& wi) const;
  std::optional<BsdfSample> sample(const Vec3& wo, float u1, const Vec2& u2) const;
  Spectrum albedo(float cos_theta) const;
};

}  // namespace umbral
