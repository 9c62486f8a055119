// Repairs of meshes that files bring: triangles without area, normals without direction.
#pragma once

#include <string>

#include "scene/shapes/mesh.h"

namespace umbral {

struct MeshRepairs {
  std::size_t triangles = 0;  // dropped: without area
  std::size_t normals =
      0;                // replaced by the mean of the neighbouring triangles': zero, infinite or not numbers
  std::size_t uvs = 0;  // set to 0: infinite or not numbers
  std::size_t colors = 0;  // cut to 0 … 1

  // "dropped 3 triangles without area"; empty if nothing was repaired.
  std::string text() const;
};

// Indices must be valid and positions finite. All normals are of unit length afterwards, colours in [0, 1].
MeshRepairs clean(Mesh& mesh);

// Whether every position is finite.
bool has_finite_positions(const Mesh& mesh);

}  // namespace umbral
