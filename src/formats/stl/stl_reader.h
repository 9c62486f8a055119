// STL files, binary and ASCII, as meshes.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "formats/input/source_text.h"
#include "scene/shapes/mesh.h"

namespace umbral {

// All facets of the file, in its order. Their normals are those of their corners, whatever the file says: many programs
// write zeros there. Solids of an ASCII file become one. Throws SceneError; what was left out is added to `warnings`.
Mesh read_stl(const std::shared_ptr<const SourceText>& source, std::vector<std::string>& warnings);

}  // namespace umbral
