// Packing vertices and triangles.
#include "scene/traced_mesh.h"

#include <bit>

namespace umbral {
namespace {

// The power of two that brings `x` > 0 into [1, 2), or near it for the smallest and largest numbers.
float normalising_power(float x) {
  const std::uint32_t exponent = std::bit_cast<std::uint32_t>(x) & 0x7f800000u;
  return std::bit_cast<float>(glm::clamp(0x7f000000u - exponent, 0x00800000u, 0x7f000000u));
}

// `sliver`: the products of the edges that make the normal round by their size, which in slivers is far above that of
// the normal. Scaled by a power of two first, which is exact: tiny edges then keep clear of denormal numbers, and a scene of
// another size has the same normals to the bit.
Triangle made_triangle(const glm::uvec3& vertices, const Vec3& a, const Vec3& b, const Vec3& c) {
  const Vec3 ab = b - a, ac = c - a;
  const Vec3 extent = glm::max(glm::abs(ab), glm::abs(ac));
  const float scale = normalising_power(max_component(extent));
  const Vec3 n = cross(ab * scale, ac * scale), e = extent * scale;
  const float inverse_length = 1 / glm::length(n);
  constexpr float relative = 4 * std::numeric_limits<float>::epsilon();
  const Vec3 largest = glm::max(glm::abs(a), glm::max(glm::abs(b), glm::abs(c)));
  return {vertices, max_component(largest), n * inverse_length,
          relative * e.x * e.y * e.z * inverse_length / scale};
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
