// The faces of an OBJ file as meshes.
#pragma once

#include <vector>

#include "formats/obj/obj_reader.h"
#include "scene/shapes/mesh.h"

namespace umbral {

struct ObjMesh {
  Mesh mesh;               // not yet cleaned
  std::uint32_t material;  // in ObjFile::materials
  int line;                // of its first face
};

enum class ObjGrouping { all, by_material };

// Vertices with the same position, uv and normal are one. Faces whose corners do not all have a normal are
// flat: they make a mesh of their own, without normals. Corners without uv have (0, 0) where others have one,
// which is told. `errors` gets concave faces that are too large.
std::vector<ObjMesh> obj_meshes(const ObjFile& file, ObjGrouping grouping, TextErrors& errors);

}  // namespace umbral
