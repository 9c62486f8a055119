// Meshes from Mitsuba's binary files (.serialized).
#pragma once

#include <string>
#include <string_view>

#include "scene/shapes/mesh.h"

namespace umbral::mitsuba_file {

// The mesh with that number in a file of version 3 or 4, whose bytes these are. Throws SceneError, located in the file
// `name`, where it is broken.
Mesh read_serialized_mesh(const std::string& name, std::string_view bytes, int index);

}  // namespace umbral::mitsuba_file
