// Loading of images that must not take more memory than there is for them.
#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "image/texture_image.h"

namespace umbral {

// As load_texture_image(), if take(bytes of its texels) says that there is room for it; else none. Never leaves it in its file.
// None for PFM, which is not counted.
std::optional<TextureImage> load_where_room(const std::string& path, ColorSpace color_space,
                                            std::vector<std::string>& repairs, std::size_t& bytes,
                                            const std::function<bool(std::size_t)>& take);

}  // namespace umbral
