// Edges and crossings of meshes.
#include "formats/meshes/mesh_topology.h"

#include <algorithm>
#include <array>
#include <numeric>
#include <tuple>

namespace umbral {
namespace {

// The same number for vertices at the same position.
std::vector<std::uint32_t> welded(const std::vector<Vec3>& positions) {
  std::vector<std::uint32_t> order(positions.size()), numbers(positions.size());
  std::iota(order.begin(), order.end(), 0u);
  const auto key = [&](std::uint32_t i) {
    return std::tuple(positions[i].x, positions[i].y, positions[i].z);
  };
  std::sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) { return key(a) < key(b); });
  for (std::size_t i = 0; i < order.size(); ++i)
    numbers[order[i]] =
        i > 0 && positions[order[i]] == positions[order[i - 1]] ? numbers[order[i - 1]] : order[i];
  return numbers;
}

// By the method of Möller and Trumbore [1997], in double.
bool crosses(const Vec3d& o, const Vec3d& d, const Vec3d& a, const Vec3d& b, const Vec3d& c) {
  const Vec3d e1 = b - a, e2 = c - a, p = cross(d, e2);
  const double determinant = dot(e1, p);
  if (determinant == 0) return false;
  const Vec3d s = (o - a) / determinant;
  const double u = dot(s, p);
  const Vec3d q = cross(s, e1);
  const double v = dot(d, q);
  return u >= 0 && v >= 0 && u + v <= 1 && dot(e2, q) > 0;
}

}  // namespace

bool is_closed(const Mesh& mesh) {
  const std::vector<std::uint32_t> numbers = welded(mesh.positions);
  std::vector<std::uint64_t> edges;
  edges.reserve(3 * mesh.triangles.size());
  for (const glm::uvec3& t : mesh.triangles)
    for (int k = 0; k < 3; ++k) {
      const auto [a, b] = std::minmax(numbers[t[k]], numbers[t[(k + 1) % 3]]);
      edges.push_back(static_cast<std::uint64_t>(a) << 32 | b);
    }
  std::sort(edges.begin(), edges.end());
  if (edges.empty() || edges.size() % 2 != 0) return false;
  for (std::size_t i = 0; i < edges.size(); i += 2)
    if (edges[i] != edges[i + 1] || (i > 0 && edges[i] == edges[i - 1])) return false;
  return true;
}

bool encloses(const Mesh& mesh, const Vec3d& p) {
  // Directions of no particular kind, so that they meet no edge of a model built along axes.
  static const std::array<Vec3d, 3> directions{Vec3d{0.7071, 0.5432, 0.4523}, Vec3d{-0.6131, 0.3917, -0.6857},
                                               Vec3d{0.1713, -0.8139, 0.5551}};
  for (const Vec3d& d : directions) {
    bool inside = false;
    for (const glm::uvec3& t : mesh.triangles)
      inside ^=
          crosses(p, d, Vec3d(mesh.positions[t.x]), Vec3d(mesh.positions[t.y]), Vec3d(mesh.positions[t.z]));
    if (!inside) return false;
  }
  return is_closed(mesh);
}

}  // namespace umbral
