// TracedMesh: a mesh as it lies in memory while rays are traced.
#pragma once

#include "core/huge_pages.h"
#include "core/math.h"
#include "scene/shapes/mesh.h"
#include "scene/textures/texture_point.h"

namespace umbral {

// All that a hit needs of a vertex, in one half of a cache line.
struct Vertex {
  Vec3 p;   // of the group's space
  Vec3 n;   // unit; of no meaning where the mesh is not smooth
  Vec2 uv;  // of no meaning where the mesh is not mapped
};
static_assert(sizeof(Vertex) == 32);

// And of a triangle: worked out once, since every hit asks for it.
struct Triangle {
  glm::uvec3 vertices;
  float magnitude;  // largest coordinate of its vertices
  Vec3 n;           // geometric normal, unit
  float sliver;  // what the ray traversal may misjudge the distance to it by beyond surface_error(magnitude)
};
static_assert(sizeof(Triangle) == 32);

struct TracedMesh {
  HugeVector<Vertex> vertices;
  HugeVector<Triangle> triangles;
  bool smooth = false;          // has normals
  bool mapped = false;          // has uv
  HugeVector<Vec2> uvs1;        // one a vertex; empty where the mesh has no second set
  HugeVector<Spectrum> colors;  // likewise

  TracedMesh() = default;
  explicit TracedMesh(const Mesh& mesh);

  // What of(vertex number) gives, interpolated.
  template <class Of>
  auto mixed(std::uint32_t triangle, const Vec2& barycentric, Of&& of) const {
    const glm::uvec3& t = triangles[triangle].vertices;
    return (1 - barycentric.x - barycentric.y) * of(t.x) + barycentric.x * of(t.y) + barycentric.y * of(t.z);
  }

  // At barycentric coordinates of a triangle; the coordinates themselves where the mesh is not mapped.
  Vec2 uv(std::uint32_t triangle, const Vec2& barycentric) const {
    return mapped ? mixed(triangle, barycentric, [&](std::uint32_t v) { return vertices[v].uv; })
                  : barycentric;
  }

  // What textures see there; beside uv only what is in `needs` (texture_needs).
  TexturePoint texture_point(std::uint32_t triangle, const Vec2& barycentric, unsigned needs) const {
    TexturePoint point = uv(triangle, barycentric);
    if (needs != 0) add_needed(triangle, barycentric, needs, point);
    return point;
  }

 private:
  void add_needed(std::uint32_t triangle, const Vec2& barycentric, unsigned needs, TexturePoint& point) const;
};

}  // namespace umbral
