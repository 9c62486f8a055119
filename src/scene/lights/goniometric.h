// Goniometric lights: points whose intensity an image gives, direction by direction.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <tuple>

#include "core/parameters.h"
#include "image/texture_image.h"
#include "scene/lights/light_bounds.h"
#include "scene/lights/light_sample.h"

namespace umbral {

// The image is latitude-longitude: its bottom row shines along `axis`, the middle row sideways, the top row back. Columns
// run round the axis; the middle one is that of `front`, and right of it come the directions of front × axis.
struct GoniometricLight {
  Vec3 position{0, 0, 0};
  Spectrum intensity = grey(1);
  std::string file;
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
          "latitude-longitude image of the intensity, bottom row along 'axis', relative to the scene file"),
      parameter<&GoniometricLight::axis>("axis", "where the bottom row shines, world, any length but 0"),
      parameter<&GoniometricLight::front>("front",
                                          "where the middle column shines, world; not along 'axis'")};

  std::shared_ptr<const TextureImage> image = nullptr;  // what the reader loads

  Spectrum intensity_towards(const Vec3& direction) const;  // unit, world
  std::optional<LightSample> sample(const Vec3& p) const;
  double power() const;
  LightBounds bounds() const;
};

}  // namespace umbral
