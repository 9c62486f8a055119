// Automatic camera and environment.
#include "formats/framing.h"

#include <fmt/format.h>

#include "formats/scene_bounds.h"

namespace umbral {
namespace {

std::string text(const Vec3& v) { return fmt::format("[{:.5g}, {:.5g}, {:.5g}]", v.x, v.y, v.z); }

bool has_light(const SceneBuilder& scene) {
  if (scene.environment || !scene.lights.empty()) return true;
  const auto shines = [](const ShapeList& list) {
    return std::any_of(list.shapes.begin(), list.shapes.end(),
                       [](const Shape& shape) { return shape.emits(); });
  };
  return shines(scene.world) ||
         std::any_of(scene.instances.begin(), scene.instances.end(),
                     [&](const Instance& i) { return shines(scene.objects[index_of(i.object)].content); });
}

}  // namespace

CameraSettings framing_camera(const Bounds& bounds, double aspect) {
  constexpr double margin = 1.1;
  CameraSettings camera;
  const Vec3d middle = (bounds.low + bounds.high) / 2.0, half = (bounds.high - bounds.low) / 2.0;
  const double slope = std::tan(glm::radians(static_cast<double>(camera.fov)) / 2);
  const double reach = margin * std::max({half.y / slope, half.x / (slope * aspect), 0.05 * half.z});
  camera.look_at = Vec3(middle);
  camera.position = Vec3(middle + Vec3d(0, 0, half.z + reach));
  return camera;
}

void complete_scene(SceneBuilder& scene, double aspect, bool light, const Place& place) {
  const Bounds bounds = bounds_of(scene);
  if (!scene.has_camera && !is_empty(bounds)) {
    scene.camera = framing_camera(bounds, aspect);
    scene.diagnostics.warning(place, fmt::format("no camera is given; it is put at {}, looking at {}",
                                                 text(scene.camera.position), text(scene.camera.look_at)));
  }
  if (light && !has_light(scene)) {
    scene.environment = EnvironmentLight{};
    scene.environment->prepare();
    scene.diagnostics.warning(place, "no light is given; a white environment lights the scene");
  }
}

}  // namespace umbral
