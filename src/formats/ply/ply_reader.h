// Meshes from PLY files.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "formats/source_text.h"
#include "scene/shapes/mesh.h"

namespace umbral {

// Positions x y z, normals nx ny nz and texture coordinates (u v, s t, texture_u texture_v or texture_s
// texture_t) of the vertices, and the polygons of the faces (vertex_indices or vertex_index); what else there
// is, is skipped. ASCII and both binary formats. The mesh is not yet cleaned. What was left out is added to
// `warnings`. Throws SceneError with the line, or the byte, where the file is broken.
Mesh read_ply(const std::shared_ptr<const SourceText>& source, std::vector<std::string>& warnings);

}  // namespace umbral
