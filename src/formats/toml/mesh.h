// Meshes written out in a document.
#pragma once

#include <optional>

#include "formats/toml/table_reader.h"
#include "scene/shapes/mesh.h"

namespace umbral::toml_file {

// Reads the keys 'vertices', 'faces', 'uvs', 'uvs1', 'normals' and 'colors' into the mesh. False where something is
// wrong, which has been told.
bool read_written_mesh(TableReader& table, Mesh& mesh);

// Makes those keys known and tells each that is there: they have no effect beside 'file'.
void refuse_written_mesh(TableReader& table);

}  // namespace umbral::toml_file
