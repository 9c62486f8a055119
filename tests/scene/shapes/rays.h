// Random rays and the list of all crossings of a shape, for the tests of shapes.
#pragma once

#include <optional>
#include <random>
#include <vector>

#include "scene/shapes/torus.h"

namespace umbral::test {

struct DoubleRay {
  Vec3d o, d;
};

inline constexpr double unbounded = std::numeric_limits<double>::infinity();

// The same numbers with every compiler and library.
class Random {
 public:
  explicit Random(std::uint64_t seed) : engine_(seed) {}

  double uniform() { return static_cast<double>(engine_() >> 11) * 0x1p-53; }
  double uniform(double low, double high) { return low + (high - low) * uniform(); }
  double power_of_ten(double low, double high) { return std::pow(10.0, uniform(low, high)); }

  glm::dvec2 square() {
    const double u = uniform();
    return {u, uniform()};
  }

  Vec2 float_square() {
    const double u = 0x1p-24 * std::floor(0x1p24 * uniform());
    return {static_cast<float>(u), static_cast<float>(0x1p-24 * std::floor(0x1p24 * uniform()))};
  }

  // Uniform on the unit sphere.
  Vec3d direction() {
    const double z = uniform(-1, 1), phi = uniform(0, 2 * pi_d), r = std::sqrt((1 - z) * (1 + z));
    return {r * std::cos(phi), r * std::sin(phi), z};
  }

  // Unit, at a right angle to the unit vector n.
  Vec3d tangent(const Vec3d& n) {
    while (true) {
      const Vec3d t = cross(n, direction());
      if (glm::length(t) > 0.1) return glm::normalize(t);
    }
  }

  // A line of the isotropic density through the ball of this radius around the origin, begun outside it.
  DoubleRay isotropic_line(double radius) {
    const Vec3d d = direction();
    const Vec3d across = radius * std::sqrt(uniform()) * tangent(d);
    return {across - 1.5 * radius * d, d};
  }

 private:
  std::mt19937_64 engine_;
};

inline Torus torus_of(double ratio) { return {1, static_cast<float>(ratio)}; }
// The ratio that such a torus has after rounding to float.
inline double ratio_of(const Torus& torus) {
  return static_cast<double>(torus.minor_radius) / static_cast<double>(torus.major_radius);
}

// Every t > 0 at which the ray crosses the shape, by asking for the next one again and again.
template <class T>
std::vector<double> crossings(const T& shape, const DoubleRay& ray) {
  std::vector<double> found;
  double t = 0;
  while (found.size() < 16) {
    const std::optional<double> next = shape.intersect(ray.o, ray.d, t, unbounded);
    if (!next) break;
    found.push_back(t = *next);
  }
  return found;
}

// How far o + t d is from the surface of the torus with tube radius a and major radius 1; in long double, so
// that only the error of t counts.
inline double distance_to_torus(double a, const DoubleRay& ray, double t) {
  const auto coordinate = [&](int i) { return ray.o[i] + static_cast<long double>(t) * ray.d[i]; };
  const long double rho = std::hypot(coordinate(0), coordinate(1)), z = coordinate(2);
  const long double outer = std::abs(std::hypot(rho - 1, z) - a),
                    inner = std::abs(std::hypot(rho + 1, z) - a);
  return static_cast<double>(std::min(outer, inner));
}

}  // namespace umbral::test
