// Panes: windows and soap bubbles, too thin for their two faces to be told apart.
#pragma once

#include <tuple>

#include "bsdf/bsdf.h"
#include "bsdf/common_parameters.h"
#include "bsdf/interfaces/fresnel.h"
#include "core/parameters.h"

namespace umbral {

// Light goes to and fro between two parallel faces that each reflect R: 2R/(1 + R) comes back, and (1 − R)/(1 + R) goes
// on straight, as the sum of all orders [Stokes 1862].
struct ThinDielectric {
  float eta = 1.5f;
  Spectrum reflectance = grey(1.0f);
  Spectrum transmittance = grey(1.0f);

  static constexpr const char* kind = "thin_dielectric";
  static constexpr const char* doc =
      "a pane of clear glass; its surface may be open, and light passes straight";
  static constexpr auto parameters = detail::clear_parameters<ThinDielectric>(
      "index of refraction of the pane over that of its surroundings");

  static constexpr bool only_delta() { return true; }
  static constexpr bool has_choice() { return true; }

  Spectrum f_cos(const Vec3&, const Vec3&) const { return black; }
  float pdf(const Vec3&, const Vec3&) const { return 0; }

  std::optional<BsdfSample> sample(const Vec3& wo, float u1, const Vec2&) const {
    const float face = fresnel_dielectric(std::abs(wo.z), eta);
    if (u1 < 2 * face / (1 + face)) return BsdfSample{{-wo.x, -wo.y, wo.z}, reflectance, 0, true};
    return BsdfSample{-wo, transmittance, 0, true};
  }

  Spectrum albedo() const { return transmittance; }

  // What is left of a pane in a local model is its highlight, that of both faces at normal incidence.
  BlinnPhongCoefficients local_model() const {
    const float face = sqr((eta - 1) / (eta + 1));
    return {black, black, reflectance * (2 * face / (1 + face)), 1000};
  }

  static constexpr bool transmits() { return true; }
};

}  // namespace umbral
