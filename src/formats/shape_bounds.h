// Boxes around shapes.
#pragma once

#include "formats/scene_builder.h"

namespace umbral {

// Around the shape once `to_world` moved it; it may be a little larger than needed for turned analytic
// shapes.
Bounds bounds_of(const Shape& shape, const Affine& to_world);

// Around the whole scene, instances among it; low > high where it has no shape.
Bounds bounds_of(const SceneBuilder& scene);

inline Bounds empty_bounds() {
  constexpr double far = std::numeric_limits<double>::infinity();
  return {Vec3d(far), Vec3d(-far)};
}
inline bool is_empty(const Bounds& b) { return !(b.low.x <= b.high.x); }
inline bool holds(const Bounds& b, const Vec3d& p) {
  return glm::all(glm::lessThanEqual(b.low, p)) && glm::all(glm::lessThanEqual(p, b.high));
}

}  // namespace umbral
