// Packing vertices.
#include "scene/traced_mesh.h"

namespace umbral {

TracedMesh::TracedMesh(const Mesh& mesh)
    : vertices(mesh.positions.size()),
      triangles(mesh.triangles.begin(), mesh.triangles.end()),
      smooth(!mesh.normals.empty()),
      mapped(!mesh.uvs.empty()) {
  for (std::size_t i = 0; i < vertices.size(); ++i)
    vertices[i] = {mesh.positions[i], smooth ? mesh.normals[i] : Vec3{0}, mapped ? mesh.uvs[i] : Vec2{0}};
}

}  // namespace umbral
