// Scene files of pbrt-v4.
#pragma once

#include <filesystem>

#include "formats/assembly/inclusion.h"
#include "formats/assembly/scene_builder.h"
#include "formats/scene_file.h"

namespace umbral::pbrt_file {

// Reads the file, and what it includes, into `builder` and the settings of `result` (not its scene). What is wrong or
// not supported is told to the builder's diagnostics; only a mistake of syntax throws SceneError.
void read_scene(const std::filesystem::path& path, const IntegratorKinds& integrators, SceneBuilder& builder,
                SceneFile& result);

// The same into the world of a scene that has settings of its own. Returns the names of the materials that are seen.
std::vector<std::string> add_scene(SceneBuilder& builder, const std::filesystem::path& path,
                                   const Inclusion& inclusion);

}  // namespace umbral::pbrt_file
