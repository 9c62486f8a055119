// The image files that a document names.
#pragma once

#include <filesystem>
#include <utility>
#include <vector>

#include "formats/assembly/scene_builder.h"
#include "formats/toml/document.h"

namespace umbral::toml_file {

// Number and file of every tile that is there; `path` holds UdimTiles::mark.
std::vector<std::pair<int, std::filesystem::path>> tile_files(const std::filesystem::path& path);

// Has the builder expect the images of all textures and lights within `value`; relative to `folder`.
void expect_images(const Value& value, const std::filesystem::path& folder, SceneBuilder& builder);

}  // namespace umbral::toml_file
