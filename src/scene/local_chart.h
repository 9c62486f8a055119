// LocalChart: how a surface, and what textures see of it, change along two parameters around a hit.
#pragma once

#include <optional>

#include "scene/textures/texture_point.h"

namespace umbral {

// The parameters are the barycentric coordinates of a triangle, or the uv of an analytic shape. On triangles all is
// linear in them.
struct LocalChart {
  TexturePoint at;
  Vec3 dp[2];           // world; zero where the parametrisation has a pole
  TexturePoint d[2];    // derivatives of `at`
  bool mapped = false;  // uv is a parametrisation of the whole shape, not each triangle's own

  // At so far from `at`; without a random number, since slopes are told from interpolated texels.
  TexturePoint shifted(int parameter, float by) const {
    const TexturePoint& change = d[parameter];
    TexturePoint result;
    result.uv = at.uv + by * change.uv;
    result.uv1 = at.uv1 + by * change.uv1;
    result.p = at.p + by * change.p;
    result.color = at.color + by * change.color;
    result.footprint = at.footprint;
    result.footprint1 = at.footprint1;
    return result;
  }
};

// Directions along which u and v grow, world, not of unit length; none where they do not both.
struct Tangents {
  Vec3 u, v;
};
std::optional<Tangents> tangents(const LocalChart& chart, const Vec2& duv0, const Vec2& duv1);

// An orthonormal frame around `n` whose s follows u and whose t is on the side of v: left-handed where uv is mirrored.
std::optional<Frame> tangent_frame(const Vec3& n, const Tangents& tangents);

}  // namespace umbral
