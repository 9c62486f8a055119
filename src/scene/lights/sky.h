// Sun and sky by a published model, made into an environment.
#pragma once

#include <tuple>

#include "core/parameters.h"
#include "scene/lights/environment.h"

namespace umbral {

// The daylight of [Preetham et al. 1999]: luminance and colour of a clear or hazy sky by a sum of exponentials, the
// sun's disk of 0.53° dimmed by air and haze, and the ground's diffuse answer to both below the horizon. The world's +y
// is up. Luminance becomes radiance by 179 lm/W.
struct SkyLight {
  Vec3 sun_direction{0.3f, 0.6f, -0.4f};
  float turbidity = 3;
  Spectrum ground = grey(0.2f);
  float scale = 0.01f;
  bool sun = true;

  static constexpr const char* kind = "sky";
  static constexpr const char* doc = "sun and clear or hazy sky; takes the place of the environment";
  static constexpr auto parameters = std::tuple{
      parameter<&SkyLight::sun_direction>("sun_direction", "towards the sun, world, above the horizon y = 0"),
      parameter<&SkyLight::turbidity>("turbidity", "haze: 2 very clear, 3 clear, 6 hazy, 10 thick",
                                      Range{1.7f, 10}),
      parameter<&SkyLight::ground>("ground", "reflectance of the ground below the horizon", zero_to_one),
      parameter<&SkyLight::scale>("scale", "multiplies the radiance; 1 is that of the day, W m⁻² sr⁻¹",
                                  non_negative),
      parameter<&SkyLight::sun>("sun", "whether the sun's disk is there, or the sky alone")};

  // Unit directions with y > 0, and towards the sun; not scaled.
  Spectrum sky_radiance(const Vec3d& direction) const;
  // On a surface that faces the sun; not scaled.
  Spectrum sun_irradiance() const;
  // With its image, prepared.
  EnvironmentLight environment() const;
};

}  // namespace umbral
