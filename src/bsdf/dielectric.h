// Smooth clear dielectrics: glass and water.
#pragma once

#include <tuple>

#include "bsdf/bsdf.h"
#include "bsdf/fresnel.h"
#include "core/parameters.h"

namespace umbral {

// Reflects by Fresnel's equations and refracts the rest by Snell's law. The normal points out of the medium, so
// the surface must be closed. Radiance changes by 1/eta² on the way in and by eta² on the way out
// [Veach 1997, §5.2]; the weight holds that factor.
struct Dielectric {
  float eta = 1.5f;
  Spectrum reflectance = grey(1.0f);
  Spectrum transmittance = grey(1.0f);

  static constexpr const char* kind = "dielectric";
  static constexpr const char* doc = "smooth glass or water; its surface must be closed";
  static constexpr bool only_delta = true;
  static constexpr bool has_choice = true;
  static constexpr auto parameters = std::tuple{
      parameter<&Dielectric::eta>("eta", "index of refraction, inside over outside", Range{1, 10}),
      parameter<&Dielectric::reflectance>("reflectance", "tint of what is reflected", zero_to_one),
      parameter<&Dielectric::transmittance>("transmittance", "tint of what is refracted", zero_to_one)};

  Spectrum f_cos(const Vec3&, const Vec3&) const { return black; }
  float pdf(const Vec3&, const Vec3&) const { return 0; }

  std::optional<BsdfSample> sample(const Vec3& wo, float u1, const Vec2&) const {
    const bool entering = wo.z > 0;
    const float relative_eta = entering ? eta : 1 / eta;
    const Vec3 up = on_side_of(wo, wo);
    const float reflected = fresnel_dielectric(up.z, relative_eta);
    if (u1 < reflected) return BsdfSample{{-wo.x, -wo.y, wo.z}, reflectance, 0, true};
    const std::optional<Vec3> down = refracted(up, relative_eta);
    if (!down) return std::nullopt;
    return BsdfSample{on_side_of(*down, wo), transmittance / sqr(relative_eta), 0, true};
  }

  Spectrum albedo() const { return transmittance; }

  // What is left of glass in a local model is its highlight, as strong as the reflection at normal incidence.
  BlinnPhongCoefficients local_model() const {
    return {black, black, reflectance * sqr((eta - 1) / (eta + 1)), 1000};
  }
};

}  // namespace umbral
