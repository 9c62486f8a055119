// The colour spaces of FLIP, and its distance of colours [Andersson et al. 2020, §4.1].
#pragma once

#include <cmath>

#include "core/math.h"

namespace umbral::flip_colour {

// Linear sRGB to XYZ over that of white; its rows sum to 1.
inline Vec3 relative_xyz(const Vec3& rgb) {
  // The matrix of IEC 61966-2-1 with exact primaries, divided by its white.
  constexpr double m[3][3] = {
      {10135552, 8788810, 4435075}, {5226144, 17577620, 1774030}, {1425312, 8788810, 70074185}};
  Vec3 xyz(0);
  for (int i = 0; i < 3; ++i) {
    const double white = m[i][0] + m[i][1] + m[i][2];
    xyz[i] = static_cast<float>(m[i][0] / white) * rgb.r + static_cast<float>(m[i][1] / white) * rgb.g +
             static_cast<float>(m[i][2] / white) * rgb.b;
  }
  return xyz;
}

// Its inverse, of which the product with relative_xyz() is 1 to the last digits of float.
Vec3 linear_rgb(const Vec3& relative_xyz);

// The opponent space Y Cx Cz [Flohr et al. 1993], which is linear: achromatic, red-green, blue-yellow.
inline Vec3 ycxcz(const Vec3& xyz) {
  return {116 * xyz.y - 16, 500 * (xyz.x - xyz.y), 200 * (xyz.y - xyz.z)};
}

inline Vec3 xyz_of_ycxcz(const Vec3& c) {
  const float y = (c.x + 16) / 116;
  return {y + c.y / 500, y, y - c.z / 200};
}

// CIELAB, whose chroma is scaled by lightness to honour the Hunt effect.
inline Vec3 hunt_adjusted_lab(const Vec3& xyz) {
  constexpr float delta = 6.0f / 29;
  Vec3 f;
  for (int i = 0; i < 3; ++i)
    f[i] = xyz[i] > delta * delta * delta ? std::cbrt(xyz[i]) : xyz[i] / (3 * delta * delta) + 4.0f / 29;
  const float lightness = 116 * f.y - 16;
  return {lightness, 0.01f * lightness * 500 * (f.x - f.y), 0.01f * lightness * 200 * (f.y - f.z)};
}

// |ΔL| + √(Δa² + Δb²) [Abasi et al. 2020].
inline float hyab(const Vec3& a, const Vec3& b) {
  const Vec3 d = a - b;
  return std::abs(d.x) + std::sqrt(d.y * d.y + d.z * d.z);
}

}  // namespace umbral::flip_colour
