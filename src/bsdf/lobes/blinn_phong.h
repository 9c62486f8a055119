// The Blinn-Phong reflection model as an energy-conserving lobe.
#pragma once

#include <tuple>

#include "bsdf/bsdf.h"
#include "bsdf/lobe_parts.h"
#include "core/parameters.h"

namespace umbral {

// f = kd/π + ks N(n) (n·h)ⁿ, h = (wo + wi)/|wo + wi| [Blinn 1977], with the norm
// N(n) = (n + 2)(n + 4)/(8π(2^(−n/2) + n)) [Giesen 2009], for which the specular part reflects ks at normal
// incidence, whatever the exponent, and no more elsewhere. Where kd + ks > 1 in a channel, both are divided by
// the sum there, so that no surface gains energy. `ka` serves the local model alone: no light is ambient in physics.
struct BlinnPhong {
  Spectrum kd = grey(0.5f);
  Spectrum ks = grey(0.0f);
  float exponent = 32;
  Spectrum ka = grey(1.0f);

  static constexpr const char* kind = "blinn_phong";
  static constexpr const char* doc = "diffuse plus a highlight around the mirror direction (Blinn-Phong)";
  static constexpr bool only_delta() { return false; }
  static constexpr bool has_choice() { return true; }
  static constexpr auto parameters = std::tuple{
      parameter<&BlinnPhong::kd>("kd", "diffuse coefficient", zero_to_one),
      parameter<&BlinnPhong::ks>("ks", "specular coefficient", zero_to_one),
      parameter<&BlinnPhong::exponent>("exponent", "shininess p (brillo): higher is sharper", Range{0, 1e6f}),
      parameter<&BlinnPhong::ka>("ka", "ambient coefficient, in the local model only", zero_to_one)};

  Spectrum f_cos(const Vec3& wo, const Vec3& wi) const;
  void each_part(const Vec3& wo, const Vec3& wi, PartVisit visit) const;
  float pdf(const Vec3& wo, const Vec3& wi) const;
  std::optional<BsdfSample> sample(const Vec3& wo, float u1, const Vec2& u2) const;
  Spectrum albedo() const;
  BlinnPhongCoefficients local_model() const { return {ka, kd, ks, exponent}; }
};

// N(n) above.
float blinn_phong_norm(float exponent);

// The two parts of f |cos θi| for coefficients whose sum may pass 1, after the division told above.
struct BlinnPhongTerms {
  Spectrum diffuse, specular;
};
BlinnPhongTerms blinn_phong_f_cos(const BlinnPhongCoefficients& k, const Vec3& wo, const Vec3& wi);

}  // namespace umbral
