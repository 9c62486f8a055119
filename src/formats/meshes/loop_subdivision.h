// Subdivision surfaces of triangles [Loop 1987].
#pragma once

#include <optional>
#include <string>

#include "scene/shapes/mesh.h"

namespace umbral {

inline constexpr std::size_t most_subdivided_triangles = std::size_t{1} << 26;

// The control mesh after `levels` steps, each of which makes four triangles of one, its vertices moved to the limit
// surface and given its normals. `control` needs positions and triangles with valid indices. Throws
// std::invalid_argument, with a sentence that says why, where an edge has more than two triangles or two that run the
// same way along it, or where the result would have more than most_subdivided_triangles.
Mesh loop_subdivided(const Mesh& control, int levels);

}  // namespace umbral
