// Camera rays.
#include "scene/camera.h"

#include "core/warp.h"

namespace umbral {

Camera::Camera(const CameraSettings& settings, int width, int height)
    : position_(settings.position),
      forward_(glm::normalize(Vec3d(settings.look_at) - Vec3d(settings.position))),
      lens_radius_(settings.orthographic_height > 0 ? 0 : settings.lens_radius),
      focus_distance_(settings.focus_distance),
      parallel_(settings.orthographic_height > 0) {
  const Vec3 unmirrored(glm::normalize(cross(Vec3d(forward_), Vec3d(settings.up))));
  const Vec3 up = cross(unmirrored, forward_);
  const Vec3 right = settings.mirrored ? -unmirrored : unmirrored;
  const float image_height =
      parallel_ ? settings.orthographic_height : 2 * std::tan(glm::radians(settings.fov) / 2);
  const float pixel = image_height / static_cast<float>(height);
  spread_ = pixel / 4;
  right_ = right * pixel;
  down_ = -up * pixel;
  const Vec2 size(width, height);
  const Vec2 middle{settings.shift.x * size.y - size.x / 2, -settings.shift.y * size.y - size.y / 2};
  corner_ = (parallel_ ? Vec3(0) : forward_) + right_ * middle.x + down_ * middle.y;
  lens_x_ = right * lens_radius_;
  lens_y_ = up * lens_radius_;
  if (!(focus_distance_ > 0))
    focus_distance_ = static_cast<float>(glm::length(Vec3d(settings.look_at) - Vec3d(settings.position)));
}

Ray Camera::ray(const Vec2& film, const Vec2& lens) const {
  const Vec3 direction = corner_ + film.x * right_ + film.y * down_;
  if (parallel_) return {position_ + direction, forward_, 0, infinity, spread_, 0};
  if (!has_lens()) return {position_, glm::normalize(direction), 0, infinity, 0, spread_};
  const Vec2 on_disk = square_to_disk(lens);
  const Vec3 offset = on_disk.x * lens_x_ + on_disk.y * lens_y_;
  return {position_ + offset, glm::normalize(direction - offset / focus_distance_), 0, infinity, 0, spread_};
}

}  // namespace umbral
