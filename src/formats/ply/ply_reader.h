// Meshes from PLY files.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "formats/input/source_text.h"
#include "scene/shapes/mesh.h"

namespace umbral {

// Which colours a mesh gets: of its vertices or faces; red, green and blue, or an attribute of one to four numbers, whose
// properties are called by its name and an ending: "weight_0", "tint_r". One number is grey, and none is an sRGB code.
struct PlyColors {
  bool of_faces = false;
  std::string attribute = {};  // empty: red, green and blue
};

// Positions x y z, normals nx ny nz and texture coordinates (u v, s t, texture_u texture_v or texture_s
// texture_t) of the vertices, and the polygons of the faces (vertex_indices or vertex_index); what else there
// is, is skipped. Colours are red green blue (r g b, color_0 color_1 color_2); with those of faces triangles share no
// vertices. ASCII and both binary formats. The mesh is not yet cleaned. What was left out is added to
// `warnings`. Throws SceneError with the line, or the byte, where the file is broken.
Mesh read_ply(const std::shared_ptr<const SourceText>& source, std::vector<std::string>& warnings,
              const PlyColors& colors = {});

}  // namespace umbral
