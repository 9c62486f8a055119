// Distant lights.
#pragma once

#include <optional>
#include <tuple>

#include "core/parameters.h"
#include "scene/lights/light_sample.h"

namespace umbral {

// Parallel light, as from the sun; no attenuation.
struct DistantLight {
  Vec3 direction{0, -1, 0};
  Spectrum irradiance = grey(1);

  static constexpr const char* kind = "distant";
  static constexpr const char* doc = "parallel light from far away";
  static constexpr auto parameters = std::tuple{
      parameter<&DistantLight::direction>("direction", "the way the light travels, world, any length but 0"),
      parameter<&DistantLight::irradiance>("irradiance", "E on a surface that faces it, W/m²", non_negative)};

  std::optional<LightSample> sample(const Vec3& p) const;
  // Through the disk of the scene's radius.
  double power(double scene_radius) const { return pi_d * sqr(scene_radius) * luminance(irradiance); }
};

}  // namespace umbral
