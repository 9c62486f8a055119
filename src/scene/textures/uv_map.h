// Where a texture lies: the placement of uv before a look-up.
#pragma once

#include "core/math.h"

namespace umbral {

// How uv is placed before a look-up: scaled, then rotated about the origin, then offset.
struct UvTransform {
  Vec2 scale{1, 1};
  float rotation = 0;  // degrees, counter-clockwise in the uv plane
  Vec2 offset{0, 0};
};

// A UvTransform made ready: two multiply-adds a coordinate.
class UvMap {
 public:
  UvMap() = default;
  explicit UvMap(const UvTransform& transform);
  Vec2 operator()(const Vec2& uv) const { return {dot(row_u_, uv) + offset_.x, dot(row_v_, uv) + offset_.y}; }

 private:
  Vec2 row_u_{1, 0}, row_v_{0, 1}, offset_{0, 0};
};

}  // namespace umbral
