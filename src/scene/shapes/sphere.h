// Spheres.
#pragma once

#include <tuple>

#include "core/parameters.h"
#include "scene/shapes/parametric.h"

namespace umbral {

// Canonical: the unit sphere. p(u, v) = (sin θ cos φ, sin θ sin φ, cos θ), φ = 2πu, θ = π(1 − v), so that
// v = 1 is at +z.
struct Sphere {
  Vec3 center{0, 0, 0};
  float radius = 1;

  static constexpr const char* kind = "sphere";
  static constexpr const char* doc = "a sphere; u runs around its z axis, v from -z to +z";
  static constexpr auto parameters = std::tuple{parameter<&Sphere::center>("center", "its centre"),
                                                parameter<&Sphere::radius>("radius", "its radius", positive)};

  Affine placement() const;
  Bounds bounds() const;
  double area() const;
  SurfacePoint at(const glm::dvec2& uv) const;
  SurfacePoint nearest(const Vec3d& p) const;
  SurfacePoint sample(const Vec2& u) const;
  std::optional<double> intersect(const Vec3d& o, const Vec3d& d, double t_min, double t_max) const;
};

}  // namespace umbral
