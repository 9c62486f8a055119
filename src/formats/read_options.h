// What a caller asks of the readers of scene files.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <string>

#include "image/texture_memory.h"

namespace umbral {

struct ReadOptions {
  // What a file asks for and umbral lacks is left out with a warning, instead of being an error.
  bool lenient = false;
  // Values for the parameters that a Mitsuba file declares with <default>.
  std::map<std::string, std::string> definitions;
  // A latitude-longitude image that takes the place of the scene's environment; empty leaves the scene's word.
  std::string environment;
  // Bytes that the texels of all images may take.
  std::uint64_t texture_memory = default_texture_memory;
  // Told how many images are decoded, of how many: from any thread, but never from two at a time. May be empty.
  std::function<void(std::size_t done, std::size_t count)> on_images = {};
};

}  // namespace umbral
