// Bounds by vertices and corners.
#include "scene/shape_bounds.h"

namespace umbral {
namespace {

Bounds bounds_of(const Mesh& mesh, const Affine& map) {
  Bounds bounds = empty_bounds();
  for (const Vec3& vertex : mesh.positions) {
    const Vec3d p = map.point(Vec3d(vertex));
    bounds = joined(bounds, {p, p});
  }
  return bounds;
}

Bounds bounds_of_corners(const Bounds& box, const Affine& map) {
  Bounds bounds = empty_bounds();
  for (int corner = 0; corner < 8; ++corner) {
    const Vec3d p = map.point({corner & 1 ? box.high.x : box.low.x, corner & 2 ? box.high.y : box.low.y,
                               corner & 4 ? box.high.z : box.low.z});
    bounds = joined(bounds, {p, p});
  }
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
          return bounds_of_corners(kind.bounds(), map * kind.placement());
        } else {
          return bounds_of(kind, map);
        }
      },
      shape.kind);
}

}  // namespace umbral
