// Boxes as twelve triangles.
#include "scene/shapes/box.h"

#include "scene/shapes/rectangle.h"

namespace umbral {

Mesh Box::triangulated() const {
  const Vec3 size = high - low;
  const Vec3 x{size.x, 0, 0}, y{0, size.y, 0}, z{0, 0, size.z};
  const Rectangle faces[6] = {{low, z, y},     {low + x, y, z}, {low, x, z},
                              {low + y, z, x}, {low, y, x},     {low + z, x, y}};
  Mesh mesh;
  for (const Rectangle& face : faces) {
    const Mesh side = face.triangulated();
    const auto first = static_cast<unsigned>(mesh.positions.size());
    mesh.positions.insert(mesh.positions.end(), side.positions.begin(), side.positions.end());
    mesh.uvs.insert(mesh.uvs.end(), side.uvs.begin(), side.uvs.end());
    for (const glm::uvec3& triangle : side.triangles) mesh.triangles.push_back(triangle + first);
  }
  return mesh;
}

}  // namespace umbral
