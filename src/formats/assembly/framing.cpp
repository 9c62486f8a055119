// Automatic camera and environment.
#include "formats/assembly/framing.h"

#include <fmt/format.h>

#include "formats/assembly/scene_bounds.h"

namespace umbral {
namespace {

std::string text(const Vec3& v) { return fmt::format("[{:.5g}, {:.5g}, {:.5g}]", v.x, v.y, v.z); }

bool has_light(const SceneBuilder& scene, float brightest_label) {
  if (scene.environment || !scene.lights.empty()) return true;
  // A texture that shines is a label or a screen: pictures to be seen, not lamps.
  const auto shines = [&](const ShapeList& list) {
    return std::any_of(list.shapes.begin(), list.shapes.end(), [&](const Shape& shape) {
      return shape.emission.is_constant() && max_component(shape.emission.value) > brightest_label;
    });
  };
  return shines(scene.world) ||
         std::any_of(scene.instances.begin(), scene.instances.end(),
                     [&](const Instance& i) { return shines(scene.objects[index_of(i.object)].content); });
}

// What is flat is not seen from its edge.
Vec3d facing(const Vec3d& half) {
  constexpr double flat = 0.1;
  if (half.y < flat * half.z) return glm::normalize(Vec3d(0, -1, -1));
  if (half.x < flat * half.z) return {-1, 0, 0};
  return {0, 0, -1};
}

}  // namespace

CameraSettings framing_camera(const Bounds& bounds, double aspect) {
  constexpr double margin = 1.1;
  CameraSettings camera;
  const Vec3d middle = (bounds.low + bounds.high) / 2.0, half = (bounds.high - bounds.low) / 2.0;
  const Vec3d view = facing(half), right = glm::normalize(cross(view, Vec3d(camera.up))),
              up = cross(right, view);
  const double slope = std::tan(glm::radians(static_cast<double>(camera.fov)) / 2);
  double distance = 0;
  for (int corner = 0; corner < 8; ++corner) {
    const Vec3d p = half * Vec3d(corner & 1 ? 1 : -1, corner & 2 ? 1 : -1, corner & 4 ? 1 : -1);
    const double before = -dot(p, view);
    const double needed = std::max(std::abs(dot(p, up)), std::abs(dot(p, right)) / aspect) / slope;
    distance = std::max({distance, before + margin * needed, 1.05 * before});
  }
  camera.look_at = Vec3(middle);
  camera.position = Vec3(middle - distance * view);
  return camera;
}

EnvironmentLight neutral_sky() {
  constexpr int width = 128, height = 64;
  const Vec3 brightest = glm::normalize(Vec3(-0.5f, 0.7f, 0.6f));
  TexelGrid<Float4> texels(width, height);
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) {
      const float elevation = ((static_cast<float>(y) + 0.5f) / height - 0.5f) * pi;
      const float azimuth = ((static_cast<float>(x) + 0.5f) / width - 0.5f) * two_pi;  // from −z towards +x
      const Vec3 direction(std::cos(elevation) * std::sin(azimuth), std::sin(elevation),
                           -std::cos(elevation) * std::cos(azimuth));
      const float sky = glm::mix(0.25f, 0.6f, glm::smoothstep(-0.1f, 0.1f, direction.y)) + 0.2f * direction.y;
      const float window = 5 * std::exp(30 * (dot(direction, brightest) - 1));
      const float radiance = sky + window;
      texels.set(x, y, {radiance, radiance, radiance, 1});
    }
  EnvironmentLight sky;
  sky.image = std::make_shared<TextureImage>(std::move(texels));
  sky.prepare();
  return sky;
}

void complete_scene(SceneBuilder& scene, double aspect, const Place& place,
                    std::optional<float> brightest_label) {
  const Bounds bounds = bounds_of(scene);
  if (!scene.has_camera && !is_empty(bounds)) {
    scene.camera = framing_camera(bounds, aspect);
    scene.diagnostics.warning(place, fmt::format("no camera is given; it is put at {}, looking at {}",
                                                 text(scene.camera.position), text(scene.camera.look_at)));
  }
  if (brightest_label && !has_light(scene, *brightest_label)) {
    scene.environment = neutral_sky();
    scene.diagnostics.warning(place,
                              "no light is given; a grey sky, brightest above to the left, lights the scene");
  }
}

}  // namespace umbral
