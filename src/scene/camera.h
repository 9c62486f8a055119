// Camera: perspective, with a thin lens where it has a radius, or orthographic.
#pragma once

#include <tuple>

#include "core/parameters.h"
#include "core/ray.h"

namespace umbral {

// What a scene file says of the camera; distances in world units.
struct CameraSettings {
  Vec3 position{0, 0, 5};
  Vec3 look_at{0, 0, 0};
  Vec3 up{0, 1, 0};
  float fov = 40;
  float orthographic_height = 0;
  float lens_radius = 0;
  float focus_distance = 0;
  bool mirrored = false;
  Vec2 shift{0, 0};

  static constexpr const char* kind = "camera";
  static constexpr const char* doc =
      "a perspective camera, with a thin lens where lens_radius > 0, or an orthographic one";
  static constexpr auto parameters = std::tuple{
      parameter<&CameraSettings::position>("position", "where the eye (the middle of the lens) is"),
      parameter<&CameraSettings::look_at>("look_at", "a point in the middle of the image"),
      parameter<&CameraSettings::up>("up", "the way that is up in the image; not along the view"),
      parameter<&CameraSettings::fov>("fov", "vertical angle of view, degrees", Range{0, 180, true, true}),
      parameter<&CameraSettings::orthographic_height>(
          "orthographic_height",
          "of the image, world units, where all rays are parallel and start in the plane of 'position'; 0 is "
          "perspective",
          non_negative),
      parameter<&CameraSettings::lens_radius>("lens_radius", "of the thin lens; 0 is a pinhole",
                                              non_negative),
      parameter<&CameraSettings::focus_distance>(
          "focus_distance", "of the sharp plane, along the view; 0 is the distance of look_at", non_negative),
      parameter<&CameraSettings::mirrored>(
          "mirrored", "left and right change places, as for worlds whose axes are left-handed"),
      parameter<&CameraSettings::shift>(
          "shift", "of the lens, right and up, in image heights: look_at leaves the middle of the image")};
};

class Camera {
 public:
  // The image is width × height pixels, which are square.
  Camera(const CameraSettings& settings, int width, int height);

  bool has_lens() const { return lens_radius_ > 0; }  // an orthographic one has none
  const Vec3& forward() const { return forward_; }    // unit, world

  // The ray through `film` (pixels from the upper left corner, x right, y down); `lens` in [0, 1)² is used only
  // where there is a lens. Its direction is of unit length; its cone a quarter of a pixel wide.
  Ray ray(const Vec2& film, const Vec2& lens) const;

 private:
  Vec3 position_, forward_;
  Vec3 right_, down_,
      corner_;            // film to the plane at distance 1 along the view; of parallel rays, at distance 0
  Vec3 lens_x_, lens_y_;  // of length lens_radius_
  float lens_radius_, focus_distance_;
  bool parallel_;
  float spread_ = 0;  // of a ray's cone; of parallel ones, its width
};

}  // namespace umbral
