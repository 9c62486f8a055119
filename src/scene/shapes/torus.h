// Tori, as their own equation and not as triangles.
#pragma once

#include <tuple>

#include "core/parameters.h"
#include "scene/shapes/parametric.h"

namespace umbral {

// Canonical: the torus around the z axis with major radius 1 and tube radius a = minor/major:
// p(u, v) = ((1 + a cos ψ) cos φ, (1 + a cos ψ) sin φ, a sin ψ), φ = 2πu, ψ = 2πv (derived in docs/torus.md).
// a > 1 is a spindle, which passes through itself; its normal is the tube's own,
// (cos ψ cos φ, cos ψ sin φ, sin ψ).
struct Torus {
  float major_radius = 1;
  float minor_radius = 0.25f;

  static constexpr const char* kind = "torus";
  static constexpr const char* doc = "a torus around the z axis; u runs around the axis, v around the tube";
  static constexpr auto parameters =
      std::tuple{parameter<&Torus::major_radius>("major_radius",
                                                 "R, from the centre to the middle of the tube", positive),
                 parameter<&Torus::minor_radius>("minor_radius", "r, of the tube", positive)};

  Affine placement() const;
  Bounds bounds() const;
  double area() const;
  SurfacePoint at(const glm::dvec2& uv) const;
  SurfacePoint nearest(const Vec3d& p) const;
  SurfacePoint sample(const Vec2& u) const;
  std::optional<double> intersect(const Vec3d& o, const Vec3d& d, double t_min, double t_max) const;

 private:
  double ratio() const { return static_cast<double>(minor_radius) / static_cast<double>(major_radius); }
};

}  // namespace umbral
