// Bilinear patches as triangles.
#pragma once

#include <array>

#include "scene/shapes/mesh.h"

namespace umbral {

// p(u, v) between the corners p(0, 0), p(1, 0), p(0, 1) and p(1, 1); its outer side is that of ∂p/∂u × ∂p/∂v.
struct BilinearPatch {
  std::array<Vec3, 4> corners;
  std::array<Vec2, 4> uvs{Vec2{0, 0}, Vec2{1, 0}, Vec2{0, 1}, Vec2{1, 1}};
  std::array<Vec3, 4> normals{};  // interpolated; of use where `has_normals`
  bool has_normals = false;

  // Two triangles are the patch itself, uv and all.
  bool is_parallelogram() const;
};

// Appends the patch as `steps` × `steps` pairs of triangles, or as one pair where that is exact. All patches of a mesh
// must agree about normals: where one is curved or has normals, all get some.
void append_patch(Mesh& mesh, const BilinearPatch& patch, int steps, bool with_normals);

}  // namespace umbral
