// Perfect mirrors.
#pragma once

#include <tuple>

#include "bsdf/bsdf.h"
#include "core/parameters.h"

namespace umbral {

// Reflects `reflectance` of the light into the mirror direction.
struct Mirror {
  Spectrum reflectance = grey(1.0f);

  static constexpr const char* kind = "mirror";
  static constexpr const char* doc = "a perfect mirror, the same at every angle";
  static constexpr bool only_delta() { return true; }
  static constexpr bool has_choice() { return false; }
  static constexpr auto parameters = std::tuple{
      parameter<&Mirror::reflectance>("reflectance", "share of the light that is reflected", zero_to_one)};

  Spectrum f_cos(const Vec3&, const Vec3&) const { return black; }
  float pdf(const Vec3&, const Vec3&) const { return 0; }

  std::optional<BsdfSample> sample(const Vec3& wo, float, const Vec2&) const {
    return BsdfSample{{-wo.x, -wo.y, wo.z}, reflectance, 0, true};
  }

  Spectrum albedo() const { return reflectance; }

  // The lecture's mirror: a sharp highlight and nothing else.
  BlinnPhongCoefficients local_model() const { return {black, black, reflectance, 1000}; }
};

}  // namespace umbral
