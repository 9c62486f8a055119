// Thin matte sheets that light shines through: paper, leaves, lampshades.
#pragma once

#include <tuple>

#include "bsdf/bsdf.h"
#include "core/parameters.h"
#include "core/warp.h"

namespace umbral {

// f = ρ/π on the side of the viewer and τ/π on the other, both Lambert's. Where ρ + τ > 1 in a channel, both are
// divided by the sum there, so that no surface gains energy.
struct DiffuseTransmission {
  Spectrum reflectance = grey(0.4f);
  Spectrum transmittance = grey(0.4f);

  static constexpr const char* kind = "diffuse_transmission";
  static constexpr const char* doc = "a thin matte sheet that light shines through: paper, a leaf";
  static constexpr auto parameters =
      std::tuple{parameter<&DiffuseTransmission::reflectance>(
                     "reflectance", "share of the light that comes back", zero_to_one),
                 parameter<&DiffuseTransmission::transmittance>(
                     "transmittance", "share of the light that shines through", zero_to_one)};

  static constexpr bool only_delta() { return false; }
  static constexpr bool has_choice() { return true; }

  Spectrum f_cos(const Vec3& wo, const Vec3& wi) const {
    if (wo.z == 0 || wi.z == 0) return black;
    return scaled(same_side(wo, wi) ? reflectance : transmittance) * (inverse_pi * std::abs(wi.z));
  }

  float pdf(const Vec3& wo, const Vec3& wi) const {
    if (wo.z == 0 || wi.z == 0) return 0;
    const float back = reflection_probability();
    return (same_side(wo, wi) ? back : 1 - back) * cosine_hemisphere_pdf(std::abs(wi.z));
  }

  std::optional<BsdfSample> sample(const Vec3& wo, float u1, const Vec2& u2) const {
    const Vec3 wi = on_side_of(square_to_cosine_hemisphere(u2), wo);
    return sample_at(*this, wo, u1 < reflection_probability() ? wi : Vec3{wi.x, wi.y, -wi.z});
  }

  Spectrum albedo() const { return scaled(reflectance + transmittance); }

  BlinnPhongCoefficients local_model() const { return {scaled(reflectance), scaled(reflectance), black, 1}; }

  static constexpr bool transmits() { return true; }

 private:
  Spectrum scaled(const Spectrum& s) const {
    return s / glm::max(Spectrum(1.0f), reflectance + transmittance);
  }

  float reflection_probability() const {
    const float back = luminance(reflectance), through = luminance(transmittance);
    return back + through > 0 ? back / (back + through) : 0.5f;
  }
};

}  // namespace umbral
