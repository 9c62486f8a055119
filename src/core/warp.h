// Warps: from the unit square to the disk, sphere, hemisphere, cone and triangle, each with its density.
#pragma once

#include "core/math.h"

namespace umbral {

// Uniform on the unit disk, concentric and area-preserving [Shirley and Chiu 1997]; density 1/π. The larger of the
// two coordinates is the radius, so the angle to its axis is within ±π/4, where Taylor's series for sine and cosine
// are exact to float with five terms and nothing depends on a branch.
inline Vec2 square_to_disk(const Vec2& u) {
  const Vec2 p = 2.0f * u - 1.0f;
  const bool wide = std::abs(p.x) > std::abs(p.y);
  const float radius = wide ? p.x : p.y;
  const float angle = radius == 0 ? 0 : (pi / 4) * ((wide ? p.y : p.x) / radius);
  const float a2 = angle * angle;
  const float sine =
      angle * (1 + a2 * (-1.f / 6 + a2 * (1.f / 120 + a2 * (-1.f / 5040 + a2 * (1.f / 362880)))));
  const float cosine = 1 + a2 * (-1.f / 2 + a2 * (1.f / 24 + a2 * (-1.f / 720 + a2 * (1.f / 40320))));
  return radius * (wide ? Vec2{cosine, sine} : Vec2{sine, cosine});
}

// Cosine-weighted on the hemisphere around +z (Malley's method); density cosine_hemisphere_pdf().
inline Vec3 square_to_cosine_hemisphere(const Vec2& u) {
  const Vec2 d = square_to_disk(u);
  return {d.x, d.y, safe_sqrt(1 - d.x * d.x - d.y * d.y)};
}

// Per solid angle; 0 below the horizon.
inline float cosine_hemisphere_pdf(float cos_theta) { return std::max(0.0f, cos_theta) * inverse_pi; }

// Uniform on the unit sphere; density 1/(4π).
inline Vec3 square_to_sphere(const Vec2& u) {
  const float z = 1 - 2 * u.x;
  const float r = 2 * safe_sqrt(u.x * (1 - u.x));
  const float phi = two_pi * u.y;
  return {r * std::cos(phi), r * std::sin(phi), z};
}

inline constexpr float sphere_pdf = 1 / (4 * pi);

// Uniform in the cone around +z whose half angle has this value of 1 − cosine (pass that, not the cosine: it
// keeps its digits for thin cones); density cone_pdf().
inline Vec3 square_to_cone(const Vec2& u, float one_minus_cos) {
  const float h = u.x * one_minus_cos;  // 1 − cos θ
  const float r = safe_sqrt(h * (2 - h));
  const float phi = two_pi * u.y;
  return {r * std::cos(phi), r * std::sin(phi), 1 - h};
}

// Per solid angle.
inline float cone_pdf(float one_minus_cos) { return 1 / (two_pi * one_minus_cos); }

// 1 − cos θ of the cone with this sin² θ, θ ≤ π/2, without cancellation.
inline float one_minus_cos_of_cone(float sin2) { return sin2 / (1 + safe_sqrt(1 - sin2)); }

// Barycentric weights (b₁, b₂) uniform on a triangle, by folding the square [Heitz 2019]; density 1/area.
inline Vec2 square_to_triangle(const Vec2& u) {
  const float half_min = 0.5f * std::min(u.x, u.y);
  return u.y > u.x ? Vec2{half_min, u.y - half_min} : Vec2{u.x - half_min, half_min};
}

// Directions around +z with density cosⁿ θ (n + 1)/(2π); see cosine_power_pdf().
inline Vec3 square_to_cosine_power(const Vec2& u, float exponent) {
  const float cos_theta = std::pow(1 - u.x, 1 / (exponent + 1));
  const float sin_theta = safe_sqrt((1 - cos_theta) * (1 + cos_theta));
  const float phi = two_pi * u.y;
  return {sin_theta * std::cos(phi), sin_theta * std::sin(phi), cos_theta};
}

// Per solid angle.
inline float cosine_power_pdf(float cos_theta, float exponent) {
  return cos_theta > 0 ? (exponent + 1) / two_pi * std::pow(cos_theta, exponent) : 0.0f;
}

}  // namespace umbral
