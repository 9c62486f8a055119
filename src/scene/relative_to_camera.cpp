// A translation of everything that has a place.
#include "scene/relative_to_camera.h"

#include <algorithm>

#include "scene/shape_bounds.h"

namespace umbral {
namespace {

double largest_coordinate(const Bounds& bounds, const Vec3d& shift) {
  const Vec3d far = glm::max(glm::abs(bounds.low + shift), glm::abs(bounds.high + shift));
  return std::max({far.x, far.y, far.z});
}

bool lies_in_space(const Texture& texture) { return (texture.needs() & texture_needs::position) != 0; }

void move(Vec3& point, const Vec3d& shift) { point = Vec3(Vec3d(point) + shift); }

void move(Shape& shape, const Vec3d& shift) {
  auto* const mesh = std::get_if<Mesh>(&shape.kind);
  if (!mesh || !shape.to_world.is_identity()) {
    shape.to_world.offset += shift;
    return;
  }
  for (Vec3& position : mesh->positions) move(position, shift);
}

void move(LightKinds& light, const Vec3d& shift) {
  std::visit(
      [&](auto& kind) {
        if constexpr (requires { kind.position; }) move(kind.position, shift);
        if constexpr (requires { kind.target; }) move(kind.target, shift);
      },
      light);
}

}  // namespace

SceneDescription relative_to_camera(SceneDescription scene) {
  if (std::any_of(scene.textures.begin(), scene.textures.end(), lies_in_space)) return scene;
  const Vec3d shift = -Vec3d(scene.camera.position);
  const Bounds bounds = bounds_of(
      scene.shapes,
      scene.instances, [&](ObjectId id) -> const auto& { return scene.objects[index_of(id)].shapes; });
  if (is_empty(bounds) || largest_coordinate(bounds, shift) >= largest_coordinate(bounds, Vec3d(0)))
    return scene;
  move(scene.camera.position, shift);
  move(scene.camera.look_at, shift);
  for (Shape& shape : scene.shapes) move(shape, shift);
  for (Instance& instance : scene.instances) instance.to_world.offset += shift;
  for (LightKinds& light : scene.lights) move(light, shift);
  return scene;
}

}  // namespace umbral
