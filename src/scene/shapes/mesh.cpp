// Transformation and area of meshes.
#include "scene/shapes/mesh.h"

namespace umbral {

void Mesh::transform(const Affine& map) {
  if (map.is_identity()) return;
  const Affine inverse_map = inverse(map);
  for (Vec3& p : positions) p = Vec3(map.point(Vec3d(p)));
  for (Vec3& n : normals) n = Vec3(glm::normalize(inverse_map.transposed(Vec3d(n))));
  if (map.determinant() < 0)
    for (glm::uvec3& triangle : triangles) std::swap(triangle.y, triangle.z);
}

double Mesh::area() const {
  double twice = 0;
  for (const glm::uvec3& t : triangles) {
    const Vec3d a(positions[t.x]), b(positions[t.y]), c(positions[t.z]);
    twice += glm::length(cross(b - a, c - a));
  }
  return twice / 2;
}

}  // namespace umbral
