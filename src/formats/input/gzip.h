// Files compressed by gzip, as pbrt scenes often come.
#pragma once

#include <string>
#include <string_view>

namespace umbral {

// The most that a compressed file may become, bytes.
inline constexpr std::size_t largest_unpacked = std::size_t{1} << 30;

// What was compressed, of one file or of several one after the other. Throws SceneError, located in `name`, where it is
// broken, ends too early or becomes too large.
std::string unpacked(std::string_view bytes, const std::string& name);

}  // namespace umbral
