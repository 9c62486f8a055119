// Irradiance in closed form, in double: what direct light must be.
#pragma once

#include <vector>

#include "core/math.h"

namespace umbral::test {

// All divided by π Le: the form factor of a light that is seen from `p` with unit normal `n`.

// A polygon with uniform radiance; counter-clockwise as seen from where it shines to, and p is there
// [Lambert 1760]. Clipped at the horizon of p.
double polygon_form_factor(const Vec3d& p, const Vec3d& n, std::vector<Vec3d> vertices);

// A sphere, p outside of it, wherever the horizon is [Snyder 1996].
double sphere_form_factor(const Vec3d& p, const Vec3d& n, const Vec3d& center, double radius);

// A disk that faces p, whose normal is opposite to that of the disk [Howell 2010, B-13].
double disk_form_factor(double height, double offset, double radius);

}  // namespace umbral::test
