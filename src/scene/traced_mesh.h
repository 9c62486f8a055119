// TracedMesh: a mesh as it lies in memory while rays are traced.
#pragma once

#include "core/huge_pages.h"
#include "core/math.h"
#include "scene/shapes/mesh.h"

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
  bool smooth = false;  // has normals
  bool mapped = false;  // has uv

  TracedMesh() = default;
  explicit TracedMesh(const Mesh& mesh);

  // At barycentric coordinates of a triangle; the coordinates themselves where the mesh is not mapped.
  Vec2 uv(std::uint32_t triangle, const Vec2& barycentric) const {
    if (!mapped) return barycentric;
    const glm::uvec3& t = triangles[triangle].vertices;
    return (1 - barycentric.x - barycentric.y) * vertices[t.x].uv + barycentric.x * vertices[t.y].uv +
           barycentric.y * vertices[t.z].uv;
  }
};

}  // namespace umbral
