// Open cylinders.
#pragma once

#include <tuple>

#include "core/parameters.h"
#include "scene/shapes/parametric.h"

namespace umbral {

// Canonical: the side of the cylinder of radius 1 around the z axis from z = 0 to 1, without caps, facing outwards.
// p(u, v) = (cos 2πu, sin 2πu, v).
struct Cylinder {
  Vec3 bottom{0, 0, 0};
  Vec3 top{0, 0, 1};
  float radius = 1;

  static constexpr const char* kind = "cylinder";
  static constexpr const char* doc = "a round tube without caps; u runs around it, v from bottom to top";
  static constexpr auto parameters =
      std::tuple{parameter<&Cylinder::bottom>("bottom", "where its axis begins"),
                 parameter<&Cylinder::top>("top", "where its axis ends"),
                 parameter<&Cylinder::radius>("radius", "its radius", positive)};

  Affine placement() const;
  Bounds bounds() const;
  double area() const;
  SurfacePoint at(const glm::dvec2& uv) const;
  SurfacePoint nearest(const Vec3d& p) const;
  SurfacePoint sample(const Vec2& u) const;
  std::optional<double> intersect(const Vec3d& o, const Vec3d& d, double t_min, double t_max) const;
};

}  // namespace umbral
