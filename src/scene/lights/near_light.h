// Where a flat light is sampled by its solid angle instead of its area.
#pragma once

namespace umbral {

// A flat light is large where its middle is nearer than the square root of so many times its area.
inline constexpr double near_areas = 4;

// Solid angles that their formulas tell to many digits; beyond, a light is seen edge-on, or is all around.
inline bool is_known_solid_angle(double solid_angle) { return solid_angle > 1e-5 && solid_angle < 6.2831; }

}  // namespace umbral
