// Bounds of all that stands in the world.
#include "formats/scene_bounds.h"

namespace umbral {

Bounds bounds_of(const SceneBuilder& scene) {
  Bounds bounds = empty_bounds();
  const auto add = [&](const std::vector<Shape>& shapes, const Affine& to_world) {
    for (const Shape& shape : shapes) bounds = joined(bounds, bounds_of(shape, to_world));
  };
  add(scene.world.shapes, Affine{});
  for (const Instance& instance : scene.instances)
    add(scene.objects[index_of(instance.object)].content.shapes, instance.to_world);
  return bounds;
}

}  // namespace umbral
