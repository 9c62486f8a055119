// Which side of a mesh is its outer one.
#pragma once

#include "scene/shapes/mesh.h"

namespace umbral {

// Turns the triangles that face away from the normals of their vertices.
void face_normals(Mesh& mesh);

// The other side becomes the outer one: triangles and normals are turned.
void turn_inside_out(Mesh& mesh);

}  // namespace umbral
