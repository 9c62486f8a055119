// Disks.
#pragma once

#include <tuple>

#include "core/parameters.h"
#include "scene/shapes/parametric.h"

namespace umbral {

// Canonical: the unit disk in the plane z = 0, facing +z. p(u, v) = v (cos 2πu, sin 2πu, 0).
struct Disk {
  Vec3 center{0, 0, 0};
  Vec3 normal{0, 0, 1};
  float radius = 1;

  static constexpr const char* kind = "disk";
  static constexpr const char* doc = "a flat disk; u runs around it, v from its centre to its edge";
  static constexpr auto parameters =
      std::tuple{parameter<&Disk::center>("center", "its centre"),
                 parameter<&Disk::normal>("normal", "the way it faces, of any length but 0"),
                 parameter<&Disk::radius>("radius", "its radius", positive)};

  Affine placement() const;
  Bounds bounds() const;
  double area() const;
  SurfacePoint at(const glm::dvec2& uv) const;
  SurfacePoint nearest(const Vec3d& p) const;
  SurfacePoint sample(const Vec2& u) const;
  std::optional<double> intersect(const Vec3d& o, const Vec3d& d, double t_min, double t_max) const;
};

}  // namespace umbral
