// Bounds of all that stands in the world.
#include "formats/assembly/scene_bounds.h"

namespace umbral {

Bounds bounds_of(const SceneBuilder& scene) {
  return bounds_of(
      scene.world.shapes, scene.instances, [&](ObjectId id) -> const auto& {
        return scene.objects[index_of(id)].content.shapes;
      });
}

}  // namespace umbral
