// Affine maps for tests: turned, unevenly scaled, often mirrored.
#pragma once

#include "scene/transform.h"
#include "support/random.h"

namespace umbral::test {

inline Affine random_rotation(Random& random) {
  const Vec3d axis = random.direction();
  return rotation(axis, random.between(0, 2 * pi_d));
}

/// A rotation, scales between low and high along axes of its own, half of them mirrored, and an offset of up to
/// `reach` in each axis.
inline Affine random_affine(Random& random, double low, double high, double reach) {
  const Affine first = random_rotation(random), second = random_rotation(random);
  Vec3d scale;
  for (int i = 0; i < 3; ++i) scale[i] = random.log_between(low, high);
  if (random.coin()) scale.x = -scale.x;
  return translation(random.in_cube(reach)) * second * scaling(scale) * first;
}

/// A rotation, one scale for all axes, and an offset.
inline Affine random_similarity(Random& random, double scale, double reach) {
  const Affine turn = random_rotation(random);
  return translation(random.in_cube(reach)) * turn * scaling(Vec3d(scale));
}

}  // namespace umbral::test
