// Analytic shapes and see-through surfaces as Embree calls back for them.
#pragma once

#include "scene/accel_embree.h"
#include "scene/geometry.h"

namespace umbral {

// What a callback needs to know of its piece; Embree keeps a pointer to it.
struct PieceContext {
  const Geometry* geometry;
  const Piece* piece;
  const Material* material;
  const std::vector<Texture>* textures;
};

// An Embree geometry for the analytic shape of `context`, not yet committed.
RTCGeometry make_user_geometry(RTCDevice device, const PieceContext& context);

// Makes rays pass where the alpha of `context`'s material says so; for triangle geometries.
void set_alpha_filter(RTCGeometry geometry, const PieceContext& context);

}  // namespace umbral
