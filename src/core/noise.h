// Noises on a lattice: functions of space that vary without order and are the same everywhere and always.
#pragma once

#include "core/math.h"

namespace umbral {

// In [−1, 1], smooth, 0 at whole numbers, features of size 1 [Perlin 2002]. 0 beyond ±10⁹.
float gradient_noise(const Vec3& p);

// The sum of `octaves` ≥ 1 gradient noises, each of half the size of the one before and `gain` times as high, divided by
// the sum of their heights: in [−1, 1] (fractional Brownian motion).
float fractal_noise(const Vec3& p, int octaves, float gain);

// Of points strewn one in each unit cube [Worley 1996]: distances to the nearest and the second nearest, and a random
// number in [0, 1) of the nearest.
struct NearestPoints {
  float first, second;
  float number;
};
NearestPoints nearest_points(const Vec3& p);

}  // namespace umbral
