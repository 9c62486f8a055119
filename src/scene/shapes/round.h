// What shapes around an axis share; all in double.
#pragma once

#include "core/math.h"

namespace umbral {

// Two axes that make a right-handed frame with the unit vector n: frame_from_normal() [Duff et al. 2017] in double.
struct AxesAcross {
  Vec3d s, t;
};
inline AxesAcross axes_across(const Vec3d& n) {
  const double sign = std::copysign(1.0, n.z);
  const double a = -1 / (sign + n.z);
  const double b = n.x * n.y * a;
  return {{1 + sign * n.x * n.x * a, sign * b, -sign * n.x}, {b, sign + n.y * n.y * a, -n.y}};
}

// How far around the z axis p lies from +x, counter-clockwise, in turns: 0 … 1.
inline double turns_around_z(const Vec3d& p) {
  const double turns = std::atan2(p.y, p.x) / (2 * pi_d);
  return turns < 0 ? turns + 1 : turns;
}

}  // namespace umbral
