// Meshes from PLY files.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "formats/input/source_text.h"
#include "scene/shapes/mesh.h"

namespace umbral {

// Whose colours a mesh gets.
enum class PlyColors { of_vertices, of_faces };

// Positions x y z, normals nx ny nz and texture coordinates (u v, s t, texture_u texture_v or texture_s
// texture_t) of the vertices, and the polygons of the faces (vertex_indices or vertex_index); what else there
// is, is skipped. Colours red green blue (r g b, color_0 color_1 color_2) are those of the vertices or of the faces, whose triangles
// then share no vertices. ASCII and both binary formats. The mesh is not yet cleaned. What was left out is added to
// `warnings`. Throws SceneError with the line, or the byte, where the file is broken.
Mesh read_ply(const std::shared_ptr<const SourceText>& source, std::vector<std::string>& warnings,
              PlyColors colors = PlyColors::of_vertices);

}  // namespace umbral
