// Transforms written as a list of steps.
#pragma once

#include "formats/toml/table_reader.h"
#include "scene/transform.h"

namespace umbral::toml_file {

// The key 'transform' of `table`: [{translate = …}, {scale = …}, {rotate = …}, {matrix = …}], applied in the
// order written; the identity where the table has none, or has a bad one, which is told.
Affine read_transform(TableReader& table);

}  // namespace umbral::toml_file
