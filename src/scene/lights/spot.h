// Spot lights.
#pragma once

#include <array>
#include <memory>
#include <optional>
#include <string>
#include <tuple>

#include "core/parameters.h"
#include "scene/lights/light_bounds.h"
#include "scene/lights/light_sample.h"
#include "scene/lights/slide.h"

namespace umbral {

// How the intensity of a spot light goes to zero: by the smooth step t²(3 − 2t) of the angle, of its cosine (as pbrt-v4), or
// straight with the angle (as Mitsuba 3).
enum class SpotEdge { smooth, smooth_cosine, linear };

template <>
struct EnumNames<SpotEdge> {
  static constexpr std::array names{"smooth", "smooth_cosine", "linear"};
};

// A point light whose intensity is full within cone_angle − edge_angle of its axis and goes to zero at cone_angle. It may
// throw an image, by which its intensity is multiplied.
struct SpotLight {
  Vec3 position{0, 0, 0};
  Vec3 target{0, 0, -1};
  Spectrum intensity = grey(1);
  float cone_angle = 30;
  float edge_angle = 5;
  SpotEdge edge = SpotEdge::smooth;
  std::string file = {};
  Vec3 up{0, 1, 0};
  float image_angle = 0;
  float image_aspect = 0;
  bool image_mirrored = false;

  static constexpr const char* kind = "spot";
  static constexpr const char* doc = "a point that shines into a cone with a soft edge";
  static constexpr auto parameters =
      std::tuple{parameter<&SpotLight::position>("position", "world"),
                 parameter<&SpotLight::target>("target", "a point on its axis, world"),
                 parameter<&SpotLight::intensity>("intensity", "I on the axis, W/sr", non_negative),
                 parameter<&SpotLight::cone_angle>("cone_angle", "from the axis to where it ends, degrees",
                                                   Range{0, 180, true, false}),
                 parameter<&SpotLight::edge_angle>(
                     "edge_angle", "over which it fades, inside the cone, degrees", Range{0, 180}),
                 parameter<&SpotLight::edge>(
                     "edge", "how it fades: by a smooth step of the angle or of its cosine, or straight"),
                 parameter<&SpotLight::file>(
                     "file", "an image that it throws, as a projector does, relative to the scene file"),
                 parameter<&SpotLight::up>(
                     "up", "where the image's upper edge lies, world; not along the axis of the light"),
                 parameter<&SpotLight::image_angle>(
                     "image_angle", "what the image's shorter side covers, degrees; 0: the whole cone",
                     Range{0, 180, false, true}),
                 parameter<&SpotLight::image_aspect>(
                     "image_aspect", "width of the image by its height, as thrown; 0: as it is in its file",
                     non_negative),
                 parameter<&SpotLight::image_mirrored>(
                     "image_mirrored", "changes left and right over, as seen from the light")};

  std::shared_ptr<const TextureImage> image = nullptr;  // what the reader loads where there is a file

  // Of the image; only where there is one.
  Slide slide() const;
  std::optional<LightSample> sample(const Vec3& p) const;
  double power() const;
  LightBounds bounds() const;

 private:
  float falloff(float cos_angle) const;
  Vec3d axis() const { return glm::normalize(Vec3d(target) - Vec3d(position)); }
  double power_by_texels() const;      // of its image, as the next
  double power_by_directions() const;  // in the cone
};

}  // namespace umbral
