// Fans and ear clipping.
#include "formats/meshes/triangulate.h"

#include <array>

namespace umbral {
namespace {

using Point = glm::dvec2;

// Twice the signed area of a triangle.
double turn(const Point& a, const Point& b, const Point& c) {
  return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

// The polygon seen from its outer side along the axis that its normal follows most: counter-clockwise.
void project(std::span<const std::uint32_t> polygon, std::span<const Vec3> positions,
             std::span<Point> points) {
  Vec3d normal{0};
  const Vec3d origin(positions[polygon[0]]);
  for (std::size_t i = 1; i + 1 < polygon.size(); ++i)
    normal += cross(Vec3d(positions[polygon[i]]) - origin, Vec3d(positions[polygon[i + 1]]) - origin);
  const Vec3d size = glm::abs(normal);
  const int axis = size.x >= size.y && size.x >= size.z ? 0 : (size.y >= size.z ? 1 : 2);
  const int u = (axis + 1) % 3, v = (axis + 2) % 3;
  const double side = normal[axis] < 0 ? -1 : 1;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Vec3d p = Vec3d(positions[polygon[i]]) - origin;
    points[i] = {side * p[u], p[v]};
  }
}

bool is_convex(std::span<const Point> points) {
  const std::size_t n = points.size();
  for (std::size_t i = 0; i < n; ++i)
    if (turn(points[i], points[(i + 1) % n], points[(i + 2) % n]) < 0) return false;
  return true;
}

// Clips one corner after the other off a polygon.
class EarClipper {
 public:
  EarClipper(std::span<const std::uint32_t> polygon, std::span<const Point> points)
      : polygon_(polygon), points_(points), left_(points.size()) {
    for (std::size_t i = 0; i < left_.size(); ++i) left_[i] = i;
  }

  void clip(std::vector<glm::uvec3>& triangles) {
    std::size_t i = 0, tried = 0;
    while (left_.size() > 3) {
      // Where no corner is an ear the polygon crosses itself: any corner will do.
      if (!is_ear(i) && ++tried < left_.size()) {
        i = (i + 1) % left_.size();
        continue;
      }
      triangles.push_back(triangle(i));
      left_.erase(left_.begin() + static_cast<std::ptrdiff_t>(i));
      i = (i + left_.size() - 1) % left_.size();
      tried = 0;
    }
    triangles.push_back(triangle(1));
  }

 private:
  std::size_t before(std::size_t i) const { return left_[(i + left_.size() - 1) % left_.size()]; }
  std::size_t after(std::size_t i) const { return left_[(i + 1) % left_.size()]; }

  glm::uvec3 triangle(std::size_t i) const {
    return {polygon_[before(i)], polygon_[left_[i]], polygon_[after(i)]};
  }

  bool is_ear(std::size_t i) const {
    const Point &a = points_[before(i)], &b = points_[left_[i]], &c = points_[after(i)];
    if (turn(a, b, c) <= 0) return false;
    for (const std::size_t other : left_) {
      const Point& p = points_[other];
      if (p == a || p == b || p == c) continue;
      if (turn(a, b, p) >= 0 && turn(b, c, p) >= 0 && turn(c, a, p) >= 0) return false;
    }
    return true;
  }

  std::span<const std::uint32_t> polygon_;
  std::span<const Point> points_;
  std::vector<std::size_t> left_;
};

}  // namespace

bool triangulate(std::span<const std::uint32_t> polygon, std::span<const Vec3> positions,
                 std::vector<glm::uvec3>& triangles) {
  if (polygon.size() == 3) {
    triangles.push_back({polygon[0], polygon[1], polygon[2]});
    return true;
  }
  std::array<Point, 8> few;  // nearly all polygons have four corners: no memory is asked for
  std::vector<Point> many(polygon.size() > few.size() ? polygon.size() : 0);
  const std::span<Point> points = many.empty() ? std::span(few).first(polygon.size()) : std::span(many);
  project(polygon, positions, points);
  if (is_convex(points)) {
    for (std::size_t i = 1; i + 1 < polygon.size(); ++i)
      triangles.push_back({polygon[0], polygon[i], polygon[i + 1]});
    return true;
  }
  if (polygon.size() > largest_concave_polygon) return false;
  EarClipper(polygon, points).clip(triangles);
  return true;
}

}  // namespace umbral
