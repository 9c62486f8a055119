// Meshes as binary PLY files.
#pragma once

#include <string>

#include "scene/shapes/mesh.h"

namespace umbral {

// All that a mesh has, in floats, so that read_ply() gives it back to the bit: normals, uv as u and v, the second set as
// u1 and v1, linear colours as red, green, blue and alpha. The file appears under its name when it is complete. Throws
// OutputError.
void write_ply(const std::string& path, const Mesh& mesh);

}  // namespace umbral
