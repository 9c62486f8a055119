// Affine maps between the spaces of shapes, instances and the world.
#pragma once

#include "core/math.h"

namespace umbral {

// x ↦ linear x + offset. Kept in double: scenes put small things far away.
struct Affine {
  glm::dmat3 linear{1.0};
  Vec3d offset{0, 0, 0};

  Vec3d point(const Vec3d& p) const { return linear * p + offset; }
  Vec3d vector(const Vec3d& v) const { return linear * v; }
  // Of a normal, not of unit length: the transpose of the *inverse* map's linear part is what carries normals,
  // so this is called on the inverse of the map that carries the points.
  Vec3d transposed(const Vec3d& n) const { return glm::transpose(linear) * n; }
  // Of the numbers that point() adds up, for a point whose coordinates are no larger than `m`.
  Vec3d magnitude(const Vec3d& m) const {
    return glm::dmat3(glm::abs(linear[0]), glm::abs(linear[1]), glm::abs(linear[2])) * m + glm::abs(offset);
  }
  double determinant() const { return glm::determinant(linear); }
  bool is_identity() const { return linear == glm::dmat3(1.0) && offset == Vec3d(0, 0, 0); }
};

// First `inner`, then `outer`.
inline Affine operator*(const Affine& outer, const Affine& inner) {
  return {outer.linear * inner.linear, outer.point(inner.offset)};
}

// `map` must have a determinant that is not 0.
inline Affine inverse(const Affine& map) {
  const glm::dmat3 linear = glm::inverse(map.linear);
  return {linear, -(linear * map.offset)};
}

inline Affine translation(const Vec3d& offset) { return {glm::dmat3(1.0), offset}; }

inline Affine scaling(const Vec3d& factors) {
  return {glm::dmat3(factors.x, 0, 0, 0, factors.y, 0, 0, 0, factors.z), {0, 0, 0}};
}

// Around the unit vector `axis` through the origin, counter-clockwise as seen against it (Rodrigues' formula).
Affine rotation(const Vec3d& axis, double radians);

// By how much `map` stretches an area element whose unit normal, before the map, is `n`: |det M| |M⁻ᵀ n|.
double area_stretch(const Affine& map, const Affine& inverse_map, const Vec3d& n);

}  // namespace umbral
