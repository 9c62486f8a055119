// PFM: floating-point pixels behind a header of three lines.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "image/texels.h"

namespace umbral {

// Whether the file's name ends in .pfm, in capitals or not.
bool is_pfm(const std::string& path);

// Throws SceneError where the bytes are not those of a whole PFM file, or of one with more than `most` texels. `name` is
// for messages.
TexelGrid<Float4> read_pfm(std::string_view bytes, const std::string& name, std::int64_t most);

}  // namespace umbral
