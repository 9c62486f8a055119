// Polygons into triangles.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/math.h"

namespace umbral {

inline constexpr std::size_t largest_concave_polygon = 10000;  // corners; the work grows with their square

// Appends the triangles of the polygon whose corners are positions[polygon[i]]: a fan where it is convex,
// else by clipping ears [Meisters 1975] in the plane that its normal (Newell's, the sum of its corners' cross
// products) faces most. Winding is kept. False, and nothing appended, for a concave polygon larger than the
// limit above.
bool triangulate(std::span<const std::uint32_t> polygon, std::span<const Vec3> positions,
                 std::vector<glm::uvec3>& triangles);

}  // namespace umbral
