// What every analytic shape offers, in a space of its own where its size is about 1.
#pragma once

#include <concepts>
#include <optional>

#include "core/math.h"
#include "scene/transform.h"

namespace umbral {

struct Bounds {
  Vec3d low, high;
};

// A point of an analytic shape, in its canonical space.
struct SurfacePoint {
  Vec3d p;
  Vec3d n;           // unit, outer side
  glm::dvec2 uv;     // in [0, 1]²
  Vec3d dpdu, dpdv;  // tangents: p's derivatives by u and v; zero at poles
};

// A shape with a parametrisation (u, v) in [0, 1]². Scene files give it by friendly parameters (a centre, a
// radius); placement() carries its canonical form to the space that those speak of. All in double: the float ray
// that Embree passes is exact in double, and so a hit loses nothing to cancellation.
template <class T>
concept ParametricShape = requires(const T& shape, const Vec3d& v, double t, const Vec2& u,
                                   const glm::dvec2& uv) {
  { shape.placement() } -> std::same_as<Affine>;  // canonical to the space of the parameters
  { shape.bounds() } -> std::same_as<Bounds>;     // everything below: canonical space
  { shape.area() } -> std::same_as<double>;
  { shape.at(uv) } -> std::same_as<SurfacePoint>;      // the parametrisation
  { shape.nearest(v) } -> std::same_as<SurfacePoint>;  // for a point within rounding of the surface
  { shape.sample(u) } -> std::same_as<SurfacePoint>;   // uniform by area
  // The first t in (t_min, t_max) at which o + t d is on the surface; d of any length.
  { shape.intersect(v, v, t, t) } -> std::same_as<std::optional<double>>;
};

}  // namespace umbral
