// The environment: light from every direction, constant or by an image.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <tuple>

#include "core/distribution.h"
#include "core/parameters.h"
#include "image/texture_image.h"
#include "scene/lights/light_sample.h"

namespace umbral {

// Images are latitude-longitude with +y up: the middle column is seen looking along −z, and columns to its right
// are further right. Sampled by the luminance of the texels times the sine of their polar angle; a cell's weight is
// the mean over its neighbours too, so that its density is positive wherever the bilinear look-up is.
struct EnvironmentLight {
  Spectrum radiance = grey(1);
  std::string file;
  float rotation = 0;
  float exposure = 0;

  static constexpr const char* kind = "environment";
  static constexpr const char* doc = "light from every direction at infinite distance";
  static constexpr auto parameters = std::tuple{
      parameter<&EnvironmentLight::radiance>("radiance", "W m⁻² sr⁻¹; multiplies the image", non_negative),
      parameter<&EnvironmentLight::file>("file",
                                         "latitude-longitude image, +y up, relative to the scene file"),
      parameter<&EnvironmentLight::rotation>("rotation", "about +y, degrees, counter-clockwise from above"),
      parameter<&EnvironmentLight::exposure>("exposure", "stops: multiplies all by 2^exposure",
                                             Range{-64, 64})};

  std::shared_ptr<const TextureImage> image = nullptr;  // what the reader loads where there is a file

  // Must be called once `image` is there.
  void prepare();
  Spectrum emitted(const Vec3& direction) const;  // unit, away from the viewer
  std::optional<LightSample> sample(const Vec2& u) const;
  float pdf(const Vec3& direction) const;  // per solid angle
  double power(double scene_radius) const;

 private:
  Vec2 uv_of(const Vec3& direction) const;

  std::shared_ptr<const Distribution2D> texels_ = nullptr;  // none for a constant
  double mean_luminance_ = 0;
  float factor_ = 1;  // 2^exposure
};

}  // namespace umbral
