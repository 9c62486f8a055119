// Boxes around shapes.
#pragma once

#include <limits>
#include <vector>

#include "scene/description.h"

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

// Around the shapes of the world and those of all instances; `shapes_of(ObjectId)` gives those of an object.
template <class ShapesOf>
Bounds bounds_of(const std::vector<Shape>& world, const std::vector<Instance>& instances,
                 const ShapesOf& shapes_of) {
  Bounds bounds = empty_bounds();
  const auto add = [&](const std::vector<Shape>& shapes, const Affine& to_world) {
    for (const Shape& shape : shapes) bounds = joined(bounds, bounds_of(shape, to_world));
  };
  add(world, Affine{});
  for (const Instance& instance : instances) add(shapes_of(instance.object), instance.to_world);
  return bounds;
}

}  // namespace umbral
