// The environment: light from every direction, constant or by an image.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <tuple>

#include "core/parameters.h"
#include "scene/lights/light_sample.h"
#include "scene/lights/sphere_distribution.h"

namespace umbral {

struct EnvironmentLight {
  Spectrum radiance = grey(1);
  std::string file;
  SphereMapping mapping = SphereMapping::equirectangular;
  float rotation = 0;
  float exposure = 0;

  static constexpr const char* kind = "environment";
  static constexpr const char* doc = "light from every direction at infinite distance";
  static constexpr auto parameters = std::tuple{
      parameter<&EnvironmentLight::radiance>("radiance", "W m⁻² sr⁻¹; multiplies the image", non_negative),
      parameter<&EnvironmentLight::file>(
          "file",
          "image over all directions, +y up, relative to the scene file; 'transform' turns "
          "and mirrors it, as it does shapes"),
      parameter<&EnvironmentLight::mapping>(
          "mapping", "how it covers them: latitude-longitude, or the octahedral square of pbrt-v4"),
      parameter<&EnvironmentLight::rotation>("rotation", "about +y, degrees, counter-clockwise from above"),
      parameter<&EnvironmentLight::exposure>("exposure", "stops: multiplies all by 2^exposure",
                                             Range{-64, 64})};

  std::shared_ptr<const TextureImage> image = nullptr;  // what the reader loads where there is a file
  // Takes world directions to the frame of the image (sphere_mapping.h), orthonormal, mirroring or not; takes the place of
  // `rotation`. For readers of formats whose environments turn about any axis.
  std::optional<Mat3> image_from_world = std::nullopt;

  // Must be called once all of the above is there.
  void prepare();
  Spectrum emitted(const Vec3& direction) const;  // unit, away from the viewer
  std::optional<LightSample> sample(const Vec2& u) const;
  float pdf(const Vec3& direction) const;  // per solid angle
  double power(double scene_radius) const;

 private:
  std::shared_ptr<const SphereDistribution> directions_ = nullptr;  // none for a constant
  Mat3 to_image_{1};
  Spectrum factor_ = grey(1);  // radiance · 2^exposure
};

}  // namespace umbral
