// Packing vertices and triangles.
#include "scene/traced_mesh.h"

namespace umbral {
namespace {

// In double, where the differences of the edges' products hardly round: in float the normal of a sliver may come out as nothing
// at all. And a scene of another size, by a power of two, has the same normals to the bit. A triangle without area is never hit.
// `sliver`: the ray traversal's own products of edges round by their size, which in slivers is far above that of the normal.
Triangle made_triangle(const glm::uvec3& vertices, const Vec3& a, const Vec3& b, const Vec3& c) {
  const Vec3d ab = Vec3d(b) - Vec3d(a), ac = Vec3d(c) - Vec3d(a);
  const Vec3d n = cross(ab, ac), e = glm::max(glm::abs(ab), glm::abs(ac));
  const Vec3 largest = glm::max(glm::abs(a), glm::max(glm::abs(b), glm::abs(c)));
  Triangle triangle{vertices, max_component(largest), {0, 0, 1}, 0};
  const double length = glm::length(n);
  if (!(length > 0)) return triangle;
  constexpr double relative = 4 * std::numeric_limits<float>::epsilon();
  triangle.n = Vec3(n / length);
  triangle.sliver = static_cast<float>(relative * e.x * e.y * e.z / length);
  return triangle;
}

}  // namespace

TracedMesh::TracedMesh(const Mesh& mesh)
    : vertices(mesh.positions.size()),
      triangles(mesh.triangles.size()),
      smooth(!mesh.normals.empty()),
      mapped(!mesh.uvs.empty()),
      uvs1(mesh.uvs1.begin(), mesh.uvs1.end()),
      colors(mesh.colors.begin(), mesh.colors.end()) {
  for (std::size_t i = 0; i < vertices.size(); ++i)
    vertices[i] = {mesh.positions[i], smooth ? mesh.normals[i] : Vec3{0}, mapped ? mesh.uvs[i] : Vec2{0}};
  const std::vector<Vec3>& p = mesh.positions;
  for (std::size_t i = 0; i < triangles.size(); ++i) {
    const glm::uvec3& t = mesh.triangles[i];
    triangles[i] = made_triangle(t, p[t.x], p[t.y], p[t.z]);
  }
}

void TracedMesh::add_needed(std::uint32_t triangle, const Vec2& barycentric, unsigned needs,
                            TexturePoint& point) const {
  point.uv1 = point.uv;
  if ((needs & texture_needs::uv1) != 0 && !uvs1.empty())
    point.uv1 = mixed(triangle, barycentric, [&](std::uint32_t v) { return uvs1[v]; });
  if ((needs & texture_needs::position) != 0)
    point.p = mixed(triangle, barycentric, [&](std::uint32_t v) { return vertices[v].p; });
  if ((needs & texture_needs::color) != 0 && !colors.empty())
    point.color = mixed(triangle, barycentric, [&](std::uint32_t v) { return colors[v]; });
}

}  // namespace umbral
