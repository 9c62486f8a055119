// Bounds by vertices and corners.
#include "formats/shape_bounds.h"

namespace umbral {
namespace {

void extend(Bounds& bounds, const Vec3d& p) {
  bounds.low = glm::min(bounds.low, p);
  bounds.high = glm::max(bounds.high, p);
}

Bounds bounds_of(const Mesh& mesh, const Affine& map) {
  Bounds bounds = empty_bounds();
  for (const Vec3& p : mesh.positions) extend(bounds, map.point(Vec3d(p)));
  return bounds;
}

}  // namespace

Bounds bounds_of(const Shape& shape, const Affine& to_world) {
  const Affine map = to_world * shape.to_world;
  return std::visit(
      [&](const auto& kind) {
        if constexpr (requires { kind.triangulated(); }) {
          return bounds_of(kind.triangulated(), map);
        } else if constexpr (requires { kind.placement(); }) {
          const Affine placed = map * kind.placement();
          const Bounds own = kind.bounds();
          Bounds bounds = empty_bounds();
          for (int corner = 0; corner < 8; ++corner)
            extend(bounds,
                   placed.point({corner & 1 ? own.high.x : own.low.x, corner & 2 ? own.high.y : own.low.y,
                                 corner & 4 ? own.high.z : own.low.z}));
          return bounds;
        } else {
          return bounds_of(kind, map);
        }
      },
      shape.kind);
}

Bounds bounds_of(const SceneBuilder& scene) {
  Bounds bounds = empty_bounds();
  const auto add = [&](const std::vector<Shape>& shapes, const Affine& to_world) {
    for (const Shape& shape : shapes) {
      const Bounds own = bounds_of(shape, to_world);
      extend(bounds, own.low);
      extend(bounds, own.high);
    }
  };
  add(scene.world.shapes, Affine{});
  for (const Instance& instance : scene.instances)
    add(scene.objects[index_of(instance.object)].content.shapes, instance.to_world);
  return bounds;
}

}  // namespace umbral
