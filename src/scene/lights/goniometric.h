// Goniometric lights: points whose intensity an image gives, direction by direction.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <tuple>

#include "core/parameters.h"
#include "scene/lights/light_bounds.h"
#include "scene/lights/light_sample.h"
#include "scene/lights/sphere_mapping.h"

namespace umbral {

// Its image is one of sphere_mapping.h whose −y is `axis` and whose −z is the part of `front` across it: that of a lamp
// that hangs, seen from the lamp. An equirectangular one has its bottom row along `axis`.
struct GoniometricLight {
  Vec3 position{0, 0, 0};
  Spectrum intensity = grey(1);
  std::string file;
  SphereMapping mapping = SphereMapping::equirectangular;
  Vec3 axis{0, -1, 0};
  Vec3 front{0, 0, -1};

  static constexpr const char* kind = "goniometric";
  static constexpr const char* doc =
      "a point whose intensity is an image over all directions, as of a luminaire";
  static constexpr auto parameters = std::tuple{
      parameter<&GoniometricLight::position>("position", "world"),
      parameter<&GoniometricLight::intensity>("intensity", "I where the image is 1, W/sr", non_negative),
      required<&GoniometricLight::file>(
          "file",
          "intensity over all directions: an image, or an .ies file; relative to the scene file. "
          "'transform', as of shapes, may turn it instead of 'axis' and 'front'"),
      parameter<&GoniometricLight::mapping>(
          "mapping", "how it covers them: latitude-longitude, or the octahedral square of pbrt-v4"),
      parameter<&GoniometricLight::axis>("axis", "down in the image: where its bottom row shines, world"),
      parameter<&GoniometricLight::front>(
          "front", "where the middle of the image's horizon shines, world; not along 'axis'")};

  std::shared_ptr<const TextureImage> image = nullptr;  // what the reader loads
  // Takes world directions to the frame of the image, orthonormal, mirroring or not; takes the place of `axis` and
  // `front`, for readers of other formats.
  std::optional<Mat3> image_from_world = std::nullopt;

  Spectrum intensity_towards(const Vec3& direction) const;  // unit, world
  std::optional<LightSample> sample(const Vec3& p) const;
  double power() const;
  LightBounds bounds() const;

 private:
  Mat3 to_image() const;
};

}  // namespace umbral
