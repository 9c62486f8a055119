// Where a ray first crosses a torus.
#pragma once

#include <optional>

#include "core/math.h"

namespace umbral {

// The first t in (t_min, t_max) at which o + t d is on the torus around the z axis with major radius 1 and
// tube radius a > 0, whose inner sheet counts too if a > 1. d may have any length but 0. A start that is on
// the surface to within the rounding of a double is no crossing, nor is a tangent that goes no deeper.
// The point o + t d is within about 1e-15 (1 + a) of the surface, plus half a digit of t.
std::optional<double> first_torus_crossing(double a, const Vec3d& o, const Vec3d& d, double t_min,
                                           double t_max);

}  // namespace umbral
