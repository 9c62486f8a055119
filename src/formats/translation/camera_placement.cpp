// From a matrix to position, view and handedness.
#include "formats/translation/camera_placement.h"

namespace umbral {

void place_camera(SceneBuilder& builder, const PlacedCamera& placed, const Place& place) {
  const Vec3d right = placed.to_world.linear[0], up = placed.to_world.linear[1];
  const double scale = glm::length(placed.orthographic ? up : placed.to_world.linear[2]);
  const Vec3d view =
      placed.orthographic ? scale * glm::normalize(placed.to_world.linear[2]) : placed.to_world.linear[2];
  if (!(scale > 0) || !std::isfinite(scale) || !is_finite(Vec3(placed.to_world.offset))) {
    builder.diagnostics.error(place, "the camera's transform gives it no direction to look in");
    return;
  }
  const auto off = [&](double value) { return !(std::abs(value) <= 1e-4 * scale * scale); };
  if (off(dot(right, up)) || off(dot(right, view)) || off(dot(up, view)) ||
      off(dot(right, right) - scale * scale) || off(dot(up, up) - scale * scale))
    builder.lacks(place, "a camera that is stretched or sheared by its transform");
  CameraSettings camera;
  const Vec3d forward = view / scale;
  camera.position = Vec3(placed.to_world.offset);
  // As far as the position is from the origin, so that neither loses the other's digits.
  const double distance = std::max(1.0, glm::length(placed.to_world.offset));
  camera.look_at = Vec3(placed.to_world.offset + distance * forward);
  camera.up = Vec3(up / glm::length(up));
  if (placed.orthographic)
    camera.orthographic_height = static_cast<float>(2 * placed.half_height * scale);
  else
    camera.fov = static_cast<float>(glm::degrees(2 * std::atan(placed.half_height)));
  camera.mirrored = dot(cross(right, up), view) > 0;
  camera.shift = Vec2(placed.center / (2 * placed.half_height));
  camera.lens_radius = static_cast<float>(placed.lens_radius * scale);
  camera.focus_distance = static_cast<float>(placed.focus_distance * scale);
  builder.add_camera({placed.name, camera, static_cast<float>(placed.aspect)});
}

}  // namespace umbral
