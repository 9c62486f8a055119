// Turning of triangles.
#include "formats/meshes/mesh_facing.h"

namespace umbral {

void face_normals(Mesh& mesh) {
  if (mesh.normals.empty()) return;
  for (glm::uvec3& t : mesh.triangles) {
    const Vec3d a(mesh.positions[t.x]), b(mesh.positions[t.y]), c(mesh.positions[t.z]);
    const Vec3d sum = Vec3d(mesh.normals[t.x]) + Vec3d(mesh.normals[t.y]) + Vec3d(mesh.normals[t.z]);
    if (dot(cross(b - a, c - a), sum) < 0) std::swap(t.y, t.z);
  }
}

void turn_inside_out(Mesh& mesh) {
  for (glm::uvec3& triangle : mesh.triangles) std::swap(triangle.y, triangle.z);
  for (Vec3& normal : mesh.normals) normal = -normal;
}

}  // namespace umbral
