// Rectangles as two triangles.
#include "scene/shapes/rectangle.h"

namespace umbral {

Mesh Rectangle::triangulated() const {
  Mesh mesh;
  mesh.positions = {origin, origin + edge_u, origin + edge_u + edge_v, origin + edge_v};
  mesh.uvs = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
  mesh.triangles = {{0, 1, 2}, {0, 2, 3}};
  return mesh;
}

}  // namespace umbral
