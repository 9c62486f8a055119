// Refinement, limit positions and limit normals of Loop's scheme.
#include "formats/meshes/loop_subdivision.h"

#include <algorithm>
#include <stdexcept>
#include <tuple>

#include <fmt/format.h>

namespace umbral {
namespace {

// An edge between vertices a < b with what lies beside it; c is opposite in the one triangle, d in the other.
struct Edge {
  std::uint32_t a, b, c, d = no_vertex;
  static constexpr std::uint32_t no_vertex = 0xffffffffu;
  bool is_boundary() const { return d == no_vertex; }
};

struct Level {
  std::vector<Vec3d> points;
  std::vector<glm::uvec3> triangles;
  std::vector<Edge> edges;                 // by (a, b)
  std::vector<glm::uvec3> triangle_edges;  // edge k runs from corner k to corner k + 1
  std::vector<bool> is_boundary;           // one a vertex
};

// Of a triangle's side, from its tail to its head, before sides are paired.
struct Side {
  std::uint32_t a, b, opposite, triangle;
  int corner;
  bool forward;  // from a to b
};

std::vector<Side> sorted_sides(const std::vector<glm::uvec3>& triangles) {
  std::vector<Side> sides;
  sides.reserve(3 * triangles.size());
  for (std::uint32_t t = 0; t < triangles.size(); ++t)
    for (int k = 0; k < 3; ++k) {
      const std::uint32_t tail = triangles[t][k], head = triangles[t][(k + 1) % 3];
      sides.push_back(
          {std::min(tail, head), std::max(tail, head), triangles[t][(k + 2) % 3], t, k, tail < head});
    }
  std::sort(sides.begin(), sides.end(), [](const Side& x, const Side& y) {
    return std::tie(x.a, x.b, x.triangle) < std::tie(y.a, y.b, y.triangle);
  });
  return sides;
}

void find_edges(Level& level) {
  level.edges.clear();
  level.triangle_edges.resize(level.triangles.size());
  level.is_boundary.assign(level.points.size(), false);
  const std::vector<Side> sides = sorted_sides(level.triangles);
  for (std::size_t i = 0; i < sides.size(); ++i) {
    const Side& side = sides[i];
    const bool is_new = i == 0 || side.a != sides[i - 1].a || side.b != sides[i - 1].b;
    if (side.a == side.b) throw std::invalid_argument(fmt::format("a triangle has vertex {} twice", side.a));
    if (is_new) {
      level.edges.push_back({side.a, side.b, side.opposite});
    } else {
      if (!level.edges.back().is_boundary())
        throw std::invalid_argument(
            fmt::format("more than two triangles share the edge from vertex {} to {}", side.a, side.b));
      if (side.forward == sides[i - 1].forward)
        throw std::invalid_argument(fmt::format(
            "the triangles beside the edge from vertex {} to {} are wound differently", side.a, side.b));
      level.edges.back().d = side.opposite;
    }
    level.triangle_edges[side.triangle][side.corner] = static_cast<std::uint32_t>(level.edges.size() - 1);
  }
  for (const Edge& edge : level.edges)
    if (edge.is_boundary()) level.is_boundary[edge.a] = level.is_boundary[edge.b] = true;
}

// Each vertex moved by its neighbours' weights: `inner(valence)` for each neighbour of an inner vertex, `border` for each
// of the two neighbours along the boundary.
template <class Weight>
std::vector<Vec3d> moved_vertices(const Level& level, Weight inner, double border) {
  std::vector<Vec3d> sums(level.points.size(), Vec3d(0));
  std::vector<int> counts(level.points.size(), 0);
  const auto add = [&](std::uint32_t to, std::uint32_t from, bool along_border) {
    if (level.is_boundary[to] && !along_border) return;
    sums[to] += level.points[from];
    ++counts[to];
  };
  for (const Edge& edge : level.edges) {
    add(edge.a, edge.b, edge.is_boundary());
    add(edge.b, edge.a, edge.is_boundary());
  }
  std::vector<Vec3d> moved(level.points.size());
  for (std::size_t i = 0; i < moved.size(); ++i) {
    const double weight = level.is_boundary[i] ? border : counts[i] > 0 ? inner(counts[i]) : 0;
    moved[i] = (1 - counts[i] * weight) * level.points[i] + weight * sums[i];
  }
  return moved;
}

double beta(int valence) { return valence == 3 ? 3.0 / 16 : 3.0 / (8.0 * valence); }

Level refined(const Level& level) {
  Level fine;
  fine.points = moved_vertices(level, beta, 1.0 / 8);
  const auto first = static_cast<std::uint32_t>(level.points.size());
  const std::vector<Vec3d>& p = level.points;
  for (const Edge& e : level.edges)
    fine.points.push_back(e.is_boundary() ? (p[e.a] + p[e.b]) / 2.0
                                          : (3.0 * (p[e.a] + p[e.b]) + p[e.c] + p[e.d]) / 8.0);
  fine.triangles.reserve(4 * level.triangles.size());
  for (std::size_t t = 0; t < level.triangles.size(); ++t) {
    const glm::uvec3 v = level.triangles[t], m = level.triangle_edges[t] + first;
    fine.triangles.insert(fine.triangles.end(),
                          {{v.x, m.x, m.z}, {m.x, v.y, m.y}, {m.z, m.y, v.z}, {m.x, m.y, m.z}});
  }
  find_edges(fine);
  return fine;
}

// Follows one triangle after the other around a vertex. The two vectors span its tangent plane.
class TangentWalk {
 public:
  explicit TangentWalk(const Level& level) : level_(level), first_(level.points.size() + 1, 0) {
    for (const glm::uvec3& t : level.triangles)
      for (int k = 0; k < 3; ++k) ++first_[t[k] + 1];
    for (std::size_t i = 1; i < first_.size(); ++i) first_[i] += first_[i - 1];
    corners_.resize(3 * level.triangles.size());
    std::vector<std::uint32_t> next = first_;
    for (const glm::uvec3& t : level.triangles)
      for (int k = 0; k < 3; ++k) corners_[next[t[k]]++] = {t[(k + 1) % 3], t[(k + 2) % 3]};
  }

  Vec3d normal(std::uint32_t vertex) const {
    std::vector<Vec3d> ring = this->ring(vertex);
    if (ring.size() < 2) return Vec3d(0);
    return level_.is_boundary[vertex] ? border_normal(level_.points[vertex], ring) : inner_normal(ring);
  }

 private:
  // The neighbours in counter-clockwise order; of a boundary vertex from one end to the other.
  std::vector<Vec3d> ring(std::uint32_t vertex) const {
    std::vector<glm::uvec2> left(corners_.begin() + first_[vertex], corners_.begin() + first_[vertex + 1]);
    std::vector<Vec3d> ring;
    if (left.empty()) return ring;
    const auto is_end = [&](const glm::uvec2& c) {
      return std::none_of(left.begin(), left.end(), [&](const glm::uvec2& o) { return o.y == c.x; });
    };
    auto at = std::find_if(left.begin(), left.end(), is_end);
    if (at == left.end()) at = left.begin();
    while (at != left.end()) {
      const glm::uvec2 corner = *at;
      left.erase(at);
      ring.push_back(level_.points[corner.x]);
      at = std::find_if(left.begin(), left.end(), [&](const glm::uvec2& c) { return c.x == corner.y; });
      if (at == left.end() && level_.is_boundary[vertex]) ring.push_back(level_.points[corner.y]);
    }
    return ring;
  }

  static Vec3d inner_normal(const std::vector<Vec3d>& ring) {
    Vec3d s(0), t(0);
    for (std::size_t j = 0; j < ring.size(); ++j) {
      const double angle = 2 * pi_d * static_cast<double>(j) / static_cast<double>(ring.size());
      s += std::cos(angle) * ring[j];
      t += std::sin(angle) * ring[j];
    }
    return cross(s, t);
  }

  // Along the boundary and across it [Hoppe et al. 1994].
  static Vec3d border_normal(const Vec3d& p, const std::vector<Vec3d>& ring) {
    const std::size_t n = ring.size();
    const Vec3d along = ring.back() - ring.front();
    Vec3d across;
    if (n == 2) {
      across = ring[0] + ring[1] - 2.0 * p;
    } else if (n == 3) {
      across = ring[1] - p;
    } else if (n == 4) {
      across = -ring[0] + 2.0 * ring[1] + 2.0 * ring[2] - ring[3] - 2.0 * p;
    } else {
      const double theta = pi_d / static_cast<double>(n - 1);
      across = -std::sin(theta) * (ring.front() + ring.back());
      for (std::size_t k = 1; k + 1 < n; ++k)
        across += (2 - 2 * std::cos(theta)) * std::sin(static_cast<double>(k) * theta) * ring[k];
    }
    return cross(across, along);
  }

  const Level& level_;
  std::vector<std::uint32_t> first_;
  std::vector<glm::uvec2> corners_;  // of each vertex's triangles: the next two vertices
};

}  // namespace

Mesh loop_subdivided(const Mesh& control, int levels) {
  if (levels > 13 || control.triangles.size() > most_subdivided_triangles >> (2 * levels))
    throw std::invalid_argument(fmt::format("{} levels of {} triangles make more than {} triangles", levels,
                                            control.triangles.size(), most_subdivided_triangles));
  Level level;
  level.points.assign(control.positions.begin(), control.positions.end());
  level.triangles = control.triangles;
  find_edges(level);
  for (int i = 0; i < levels; ++i) level = refined(level);
  const std::vector<Vec3d> limit = moved_vertices(
      level, [](int n) { return 1 / (n + 3 / (8 * beta(n))); }, 1.0 / 5);
  const TangentWalk tangents(level);
  Mesh mesh;
  mesh.triangles = level.triangles;
  for (std::uint32_t i = 0; i < limit.size(); ++i) {
    mesh.positions.push_back(Vec3(limit[i]));
    const Vec3d normal = tangents.normal(i);
    mesh.normals.push_back(glm::length(normal) > 0 ? Vec3(glm::normalize(normal)) : Vec3(0));
  }
  return mesh;
}

}  // namespace umbral
