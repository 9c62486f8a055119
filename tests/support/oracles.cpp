// Form factors of polygons, spheres and disks.
#include "support/oracles.h"

namespace umbral::test {
namespace {

// The part of the polygon with dot(v, n) ≥ 0 (Sutherland-Hodgman).
std::vector<Vec3d> clipped_at_horizon(const std::vector<Vec3d>& vertices, const Vec3d& n) {
  std::vector<Vec3d> result;
  for (std::size_t i = 0; i < vertices.size(); ++i) {
    const Vec3d &a = vertices[i], &b = vertices[(i + 1) % vertices.size()];
    const double above_a = dot(a, n), above_b = dot(b, n);
    if (above_a >= 0) result.push_back(a);
    if ((above_a > 0 && above_b < 0) || (above_a < 0 && above_b > 0))
      result.push_back(a + (b - a) * (above_a / (above_a - above_b)));
  }
  return result;
}

}  // namespace

// E/(π Le) = (1/2π) Σ Θᵢ Γᵢ·n over the edges.
double polygon_form_factor(const Vec3d& p, const Vec3d& n, std::vector<Vec3d> vertices) {
  for (Vec3d& v : vertices) v -= p;
  vertices = clipped_at_horizon(vertices, n);
  double sum = 0;
  for (std::size_t i = 0; i < vertices.size(); ++i) {
    const Vec3d a = glm::normalize(vertices[i]), b = glm::normalize(vertices[(i + 1) % vertices.size()]);
    const Vec3d across = cross(a, b);
    const double sine = glm::length(across);
    if (sine > 0) sum += std::atan2(sine, dot(a, b)) * dot(across / sine, n);
  }
  return std::abs(sum) / (2 * pi_d);
}

double sphere_form_factor(const Vec3d& p, const Vec3d& n, const Vec3d& center, double radius) {
  const double distance = glm::length(center - p);
  const double h = distance / radius;
  const double cos_beta = dot(center - p, n) / distance;
  const double beta = std::acos(glm::clamp(cos_beta, -1.0, 1.0));
  const double limit = std::acos(1 / h);
  if (beta <= limit) return cos_beta / (h * h);
  if (beta >= pi_d - limit) return 0;
  const double x = std::sqrt(h * h - 1), sin_beta = std::sin(beta);
  const double y = -x * cos_beta / sin_beta;
  const double root = std::sqrt(1 - y * y);
  return (cos_beta * std::acos(y) - x * sin_beta * root) / (pi_d * h * h) +
         std::atan(sin_beta * root / x) / pi_d;
}

double disk_form_factor(double height, double offset, double radius) {
  const double r2 = sqr(radius / height), a2 = sqr(offset / height);
  const double sum = 1 + a2 + r2;
  return 0.5 * (1 - (1 + a2 - r2) / std::sqrt(sum * sum - 4 * a2 * r2));
}

}  // namespace umbral::test
