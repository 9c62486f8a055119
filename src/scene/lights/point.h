// Point lights.
#pragma once

#include <optional>
#include <tuple>

#include "core/parameters.h"
#include "scene/lights/light_bounds.h"
#include "scene/lights/light_sample.h"

namespace umbral {

// The same intensity I in every direction; irradiance falls with 1/r².
struct PointLight {
  Vec3 position{0, 0, 0};
  Spectrum intensity = grey(1);

  static constexpr const char* kind = "point";
  static constexpr const char* doc = "a point that shines the same way everywhere";
  static constexpr auto parameters =
      std::tuple{parameter<&PointLight::position>("position", "world"),
                 parameter<&PointLight::intensity>("intensity", "I, radiant intensity, W/sr", non_negative)};

  std::optional<LightSample> sample(const Vec3& p) const;
  double power() const { return 4 * pi_d * luminance(intensity); }
  LightBounds bounds() const { return bounds_of_point(Vec3d(position), luminance(intensity)); }
};

}  // namespace umbral
