// Boxes around shapes.
#pragma once

#include <limits>

#include "scene/shapes/shapes.h"

namespace umbral {

// Around the shape once `to_world` moved it; it may be a little larger than needed for turned analytic
// shapes.
Bounds bounds_of(const Shape& shape, const Affine& to_world);

inline Bounds empty_bounds() {
  constexpr double far = std::numeric_limits<double>::infinity();
  return {Vec3d(far), Vec3d(-far)};
}
inline bool is_empty(const Bounds& b) { return !(b.low.x <= b.high.x); }
inline bool holds(const Bounds& b, const Vec3d& p) {
  return glm::all(glm::lessThanEqual(b.low, p)) && glm::all(glm::lessThanEqual(p, b.high));
}
inline Bounds joined(const Bounds& a, const Bounds& b) {
  return {glm::min(a.low, b.low), glm::max(a.high, b.high)};
}

}  // namespace umbral
