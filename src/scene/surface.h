// What a ray hits, in two steps: Embree's bare numbers, and the surface made from them on demand.
#pragma once

#include "core/ray.h"
#include "scene/ids.h"
#include "scene/textures/texture_point.h"

namespace umbral {

// What the ray traversal knows.
struct Hit {
  float t;                 // in lengths of the ray's direction
  std::uint32_t instance;  // no_index where the shape stands in the world itself
  std::uint32_t geometry;  // within the world, or within the instance's object
  std::uint32_t primitive;
  Vec2 barycentric;  // of triangles
};

// A point of a surface, in world space.
struct Surface {
  Vec3 p;
  Vec3 ng;          // geometric normal, unit, on the outer side (the one that emits)
  Frame shading;    // its n is the interpolated normal, on the same side as ng
  TexturePoint at;  // what textures see
  float error;      // bound on how far p lies from the true surface, along ng; world units
  MaterialId material = MaterialId::none;
  LightId light = LightId::none;
  unsigned detail = 0;  // what its material asks for beyond this (surface_detail)
  Vec3
      clearcoat_normal;  // as that of `shading`, of a clearcoat that has one of its own; set by its detail alone

  // Where rays leave towards `direction`: p moved along ng out of the reach of its own error.
  Vec3 origin_towards(const Vec3& direction) const {
    return p + (dot(direction, ng) < 0 ? -error : error) * ng;
  }

  Ray ray_towards(const Vec3& direction) const { return {origin_towards(direction), direction}; }
};

// The bound that Surface::error holds, for a point made from numbers no larger than `magnitude` in any axis: 32
// units in the last place of it. Not of each axis for itself, projected on the normal: a plane y = 0 has
// vertices without any error in y, but the ray traversal rounds distances to it as it does to any other.
inline float surface_error(float magnitude) { return 32 * std::numeric_limits<float>::epsilon() * magnitude; }

}  // namespace umbral
