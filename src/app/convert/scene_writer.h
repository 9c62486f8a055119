// A scene of any format in our own: a TOML file, and a folder beside it with its meshes and images.
#pragma once

#include <filesystem>

#include "app/load_scene.h"

namespace umbral {

/// Writes `path` and the folder `path` without its ending plus "-files". Images are referred to where they are files that
/// read back the same, else written as EXR; meshes are PLY files of floats. What nothing uses is left out. `source` is the
/// file that the scene was read from. Throws OutputError.
void write_scene(const LoadedScene& scene, const std::filesystem::path& source,
                 const std::filesystem::path& path);

}  // namespace umbral
