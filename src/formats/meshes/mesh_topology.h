// Whether a mesh encloses space, and whether a point lies in it.
#pragma once

#include "scene/shapes/mesh.h"

namespace umbral {

// Every edge belongs to exactly two triangles, vertices at the same position counting as one.
bool is_closed(const Mesh& mesh);

// Whether `p` lies inside the closed mesh: rays in three directions all leave it an odd number of times.
// False for a mesh that is not closed.
bool encloses(const Mesh& mesh, const Vec3d& p);

}  // namespace umbral
