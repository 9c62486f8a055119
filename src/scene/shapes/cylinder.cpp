// The unit cylinder: placement, parametrisation and ray intersection.
#include "scene/shapes/cylinder.h"

#include "scene/shapes/round.h"

namespace umbral {
namespace {

SurfacePoint point_of_cylinder(double cos_phi, double sin_phi, const glm::dvec2& uv) {
  const Vec3d n(cos_phi, sin_phi, 0);
  return {n + Vec3d(0, 0, uv.y), n, uv, 2 * pi_d * Vec3d(-sin_phi, cos_phi, 0), {0, 0, 1}};
}

}  // namespace

Affine Cylinder::placement() const {
  const Vec3d axis = Vec3d(top) - Vec3d(bottom);
  const auto [s, t] = axes_across(glm::normalize(axis));
  return {glm::dmat3(static_cast<double>(radius) * s, static_cast<double>(radius) * t, axis), Vec3d(bottom)};
}

Bounds Cylinder::bounds() const { return {{-1, -1, 0}, {1, 1, 1}}; }

double Cylinder::area() const { return 2 * pi_d; }

SurfacePoint Cylinder::at(const glm::dvec2& uv) const {
  const double phi = 2 * pi_d * uv.x;
  return point_of_cylinder(std::cos(phi), std::sin(phi), uv);
}

SurfacePoint Cylinder::nearest(const Vec3d& p) const {
  const double r = std::hypot(p.x, p.y);
  const glm::dvec2 uv(r > 0 ? turns_around_z(p) : 0, glm::clamp(p.z, 0.0, 1.0));
  return r > 0 ? point_of_cylinder(p.x / r, p.y / r, uv) : point_of_cylinder(1, 0, uv);
}

SurfacePoint Cylinder::sample(const Vec2& u) const { return at(glm::dvec2(u)); }

// As for the sphere, but across the axis: from the point q nearest to it nothing cancels.
std::optional<double> Cylinder::intersect(const Vec3d& o, const Vec3d& d, double t_min, double t_max) const {
  const double dd = d.x * d.x + d.y * d.y;
  if (!(dd > 0)) return std::nullopt;  // along the axis
  const double t_q = -(o.x * d.x + o.y * d.y) / dd;
  const glm::dvec2 q(std::fma(t_q, d.x, o.x), std::fma(t_q, d.y, o.y));
  const double b = q.x * d.x + q.y * d.y;  // 0 but for the rounding of t_q
  const double discriminant = b * b + dd * (1 - dot(q, q));
  if (!(discriminant >= 0)) return std::nullopt;
  const double root = std::sqrt(discriminant);
  for (const double t : {t_q - (b + root) / dd, t_q - (b - root) / dd}) {
    const double z = std::fma(t, d.z, o.z);
    if (t > t_min && t < t_max && z >= 0 && z <= 1) return t;
  }
  return std::nullopt;
}

}  // namespace umbral
