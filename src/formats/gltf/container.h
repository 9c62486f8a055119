// The binary container of glTF (.glb): a header, a chunk of JSON and perhaps one of bytes.
#pragma once

#include <optional>
#include <string_view>

#include "formats/gltf/report.h"

namespace umbral::gltf {

struct Container {
  std::string_view json;
  std::optional<std::string_view> binary;
};

// Whether the bytes are meant as a container: they are a .glb file's, or begin as one.
bool is_container(std::string_view bytes, bool named_glb);

// Parts of `bytes`; what is wrong is told, and then there is nothing.
std::optional<Container> read_container(std::string_view bytes, Report& report);

}  // namespace umbral::gltf
