// The sections of a TOML scene file.
#pragma once

#include <filesystem>

#include "formats/assembly/scene_builder.h"
#include "formats/scene_file.h"

namespace umbral::toml_file {

// Reads the document into `builder` and the settings of `result` (not its scene). What is wrong is told to
// the builder's diagnostics; only a mistake of syntax throws SceneError.
void read_scene(const std::shared_ptr<const SourceText>& source, const std::filesystem::path& folder,
                const IntegratorKinds& integrators, SceneBuilder& builder, SceneFile& result);

// What a file without settings has: the default integrator, each kind of which gets an empty table.
void read_no_settings(const IntegratorKinds& integrators, Diagnostics& diagnostics, SceneFile& result);

}  // namespace umbral::toml_file
