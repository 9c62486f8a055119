// Rotations and the stretch of areas.
#include "scene/transform.h"

namespace umbral {

Affine rotation(const Vec3d& axis, double radians) {
  const double c = std::cos(radians), s = std::sin(radians);
  const glm::dmat3 cross_product(0, axis.z, -axis.y, -axis.z, 0, axis.x, axis.y, -axis.x, 0);
  return {glm::dmat3(c) + s * cross_product + (1 - c) * glm::outerProduct(axis, axis), {0, 0, 0}};
}

double area_stretch(const Affine& map, const Affine& inverse_map, const Vec3d& n) {
  return std::abs(map.determinant()) * glm::length(inverse_map.transposed(n));
}

}  // namespace umbral
