// From the bytes of a glTF file to a Document that is safe to use.
#pragma once

#include <filesystem>
#include <optional>

#include "formats/gltf/document.h"
#include "formats/gltf/report.h"
#include "formats/input/input_files.h"

namespace umbral::gltf {

// Every reference is valid, every accessor lies within its buffer, nodes are trees. Breaches of the standard are
// errors, but for those that cannot change the image, which are warnings (docs/formats.md). None where there are errors.
std::optional<Document> read_document(const std::filesystem::path& path, InputFiles& files, Report& report);

}  // namespace umbral::gltf
