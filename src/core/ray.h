// Rays: an origin, a direction and the open interval in which something may be hit.
#pragma once

#include "core/math.h"

namespace umbral {

// Points on it are o + t d, t_min < t < t_max. `d` need not be of unit length.
struct Ray {
  Vec3 o;           // world
  Vec3 d;           // world
  float t_min = 0;  // in lengths of d
  float t_max = infinity;
  // The cone of rays that this one stands for [Akenine-Möller et al. 2021]; kept up only in scenes that look at it.
  float width = 0;   // at o, world units
  float spread = 0;  // by which it widens per unit of distance

  Vec3 operator()(float t) const { return o + t * d; }
};

}  // namespace umbral
