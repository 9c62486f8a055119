// What an image file will take in memory.
#pragma once

#include <cstddef>
#include <optional>
#include <string>

#include "image/texture_image.h"

namespace umbral {

// Bytes that load_texture_image() will take of its TextureMemory, from the file's header; none where it cannot be opened,
// and for PFM, which takes nothing.
std::optional<std::size_t> texture_bytes(const std::string& path, ColorSpace color_space);

}  // namespace umbral
