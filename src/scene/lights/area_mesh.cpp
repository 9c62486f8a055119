// Sampling emitting meshes: the choice of a triangle, then a point on it.
#include "core/warp.h"
#include "scene/lights/area.h"
#include "scene/lights/near_light.h"

namespace umbral {

AreaLight::Corners AreaLight::corners_of(std::uint32_t triangle) const {
  const glm::uvec3& t = mesh_->triangles[triangle].vertices;
  return {world(mesh_->vertices[t.x].p), world(mesh_->vertices[t.y].p), world(mesh_->vertices[t.z].p)};
}

AreaLight::Point AreaLight::triangle_point(std::uint32_t index, const Vec2& b) const {
  const Triangle& triangle = mesh_->triangles[index];
  const glm::uvec3& t = triangle.vertices;
  const Vec3 &a = mesh_->vertices[t.x].p, &e = mesh_->vertices[t.y].p, &f = mesh_->vertices[t.z].p;
  const Vec3d p = world((1 - b.x - b.y) * a + b.x * e + b.y * f);
  const Vec3d n = cross(Vec3d(e) - Vec3d(a), Vec3d(f) - Vec3d(a));
  return {Vec3(p),
          Vec3(glm::normalize(from_world_.transposed(n))),
          std::max(surface_error(triangle.magnitude), placed_error_),
          b,
          0,
          false,
          index};
}

std::optional<SphericalTriangle> AreaLight::triangle_from(const Vec3& p, const Corners& t) {
  const Vec3d way = (t.a + t.b + t.c) / 3.0 - Vec3d(p);
  if (!(dot(way, way) < near_areas * t.area())) return std::nullopt;
  const SphericalTriangle seen(Vec3d(p), t.a, t.b, t.c);
  return is_known_solid_angle(seen.solid_angle()) ? std::optional(seen) : std::nullopt;
}

AreaLight::Point AreaLight::mesh_point(const LightReceiver& receiver, const Vec2& u) const {
  std::uint32_t index = 0;
  Vec2 square = u;
  float probability = 1;
  if (triangle_tree_.empty()) {
    const Distribution1D::Draw draw = triangles_.sample(u.x);
    index = static_cast<std::uint32_t>(draw.index);
    square.x = draw.remainder;
    probability = draw.probability;
  } else {
    const auto choice = triangle_tree_.choose(receiver, u.x);
    if (!choice) return {};
    index = choice->light;
    square.x = choice->remainder;
    probability = choice->probability;
  }
  const Corners corners = corners_of(index);
  if (const auto seen = triangle_from(receiver.p, corners)) {
    // Where the direction meets the plane, as weights of b and c.
    const Vec3d w = seen->sample(square), ab = corners.b - corners.a, ac = corners.c - corners.a;
    const Vec3d from_a = Vec3d(receiver.p) - corners.a, h = cross(w, ac);
    const double below = dot(ab, h);
    const double b = std::clamp(dot(from_a, h) / below, 0.0, 1.0);
    const double c = std::clamp(dot(w, cross(from_a, ab)) / below, 0.0, 1 - b);
    Point point = triangle_point(index, Vec2(glm::dvec2(b, c)));
    point.pdf = static_cast<float>(static_cast<double>(probability) / seen->solid_angle());
    point.by_solid_angle = true;
    return point;
  }
  Point point = triangle_point(index, square_to_triangle(square));
  point.pdf = triangle_tree_.empty() ? inverse_area_
                                     : static_cast<float>(static_cast<double>(probability) / corners.area());
  return point;
}

float AreaLight::mesh_pdf(const LightReceiver& receiver, const Hit& hit, float area_to_angle) const {
  const bool by_area = triangle_tree_.empty();
  const Corners corners = corners_of(hit.primitive);
  const auto seen = triangle_from(receiver.p, corners);
  if (by_area && !seen) return inverse_area_ * area_to_angle;
  const double probability = static_cast<double>(
      by_area ? triangles_.probability(hit.primitive) : triangle_tree_.probability(receiver, hit.primitive));
  return static_cast<float>(
      probability * (seen ? 1 / seen->solid_angle() : static_cast<double>(area_to_angle) / corners.area()));
}

}  // namespace umbral
