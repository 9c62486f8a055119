// Vectors, constants and small functions of geometry that every room shares.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>

#include <glm/glm.hpp>

namespace umbral {

using Vec2 = glm::vec2;
using Vec3 = glm::vec3;
using Vec3d = glm::dvec3;
using Mat3 = glm::mat3;

inline constexpr float pi = 3.14159265358979323846f;
inline constexpr float two_pi = 2 * pi;
inline constexpr float inverse_pi = 1 / pi;
inline constexpr double pi_d = 3.14159265358979323846;
inline constexpr float infinity = std::numeric_limits<float>::infinity();
inline constexpr float one_minus_epsilon = 0x1.fffffep-1f;  // the largest float below 1

template <class T>
constexpr T sqr(T x) {
  return x * x;
}

inline float safe_sqrt(float x) { return std::sqrt(std::max(0.0f, x)); }

inline float max_component(const Vec3& v) { return std::max({v.x, v.y, v.z}); }

inline bool is_finite(const Vec3& v) {
  return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

inline bool is_finite(const Vec2& v) { return std::isfinite(v.x) && std::isfinite(v.y); }

// An orthonormal frame; its local z is `n`. Directions go to and from it without scale.
struct Frame {
  Vec3 s{1, 0, 0}, t{0, 1, 0}, n{0, 0, 1};

  Vec3 to_local(const Vec3& v) const { return {dot(v, s), dot(v, t), dot(v, n)}; }
  Vec3 to_world(const Vec3& v) const { return s * v.x + t * v.y + n * v.z; }
};

// A frame around the unit vector `n`, without branches or square roots [Duff et al. 2017].
inline Frame frame_from_normal(const Vec3& n) {
  const float sign = std::copysign(1.0f, n.z);
  const float a = -1 / (sign + n.z);
  const float b = n.x * n.y * a;
  return {{1 + sign * n.x * n.x * a, sign * b, -sign * n.x}, {b, sign + n.y * n.y * a, -n.y}, n};
}

// A frame around the unit vector `n` whose s follows `tangent`; any frame where the two are parallel.
inline Frame frame_from_normal_and_tangent(const Vec3& n, const Vec3& tangent) {
  const Vec3 s = tangent - n * dot(n, tangent);
  const float length2 = dot(s, s);
  if (!(length2 > 1e-12f * dot(tangent, tangent))) return frame_from_normal(n);
  const Vec3 unit = s / std::sqrt(length2);
  return {unit, cross(n, unit), n};
}

}  // namespace umbral
