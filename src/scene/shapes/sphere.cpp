// The unit sphere: placement, parametrisation and ray intersection.
#include "scene/shapes/sphere.h"

#include "scene/shapes/round.h"

namespace umbral {
namespace {

struct Turn {
  double cosine, sine;
};

SurfacePoint point_of_sphere(const Turn& theta, const Turn& phi, const glm::dvec2& uv) {
  const Vec3d n(theta.sine * phi.cosine, theta.sine * phi.sine, theta.cosine);
  const Vec3d dpdu = 2 * pi_d * Vec3d(-n.y, n.x, 0);
  const Vec3d dpdv = pi_d * Vec3d(-theta.cosine * phi.cosine, -theta.cosine * phi.sine, theta.sine);
  return {n, n, uv, dpdu, dpdv};
}

}  // namespace

Affine Sphere::placement() const { return translation(Vec3d(center)) * scaling(Vec3d(radius)); }

Bounds Sphere::bounds() const { return {Vec3d(-1), Vec3d(1)}; }

double Sphere::area() const { return 4 * pi_d; }

SurfacePoint Sphere::at(const glm::dvec2& uv) const {
  const double phi = 2 * pi_d * uv.x, theta = pi_d * (1 - uv.y);
  return point_of_sphere({std::cos(theta), std::sin(theta)}, {std::cos(phi), std::sin(phi)}, uv);
}

SurfacePoint Sphere::nearest(const Vec3d& p) const {
  const double rho = std::hypot(p.x, p.y), length = std::hypot(rho, p.z);
  const Turn theta = length > 0 ? Turn{p.z / length, rho / length} : Turn{1, 0};
  const Turn phi = rho > 0 ? Turn{p.x / rho, p.y / rho} : Turn{1, 0};
  const double v = 1 - std::atan2(theta.sine, theta.cosine) / pi_d;
  return point_of_sphere(theta, phi, {turns_around_z(p), v});
}

SurfacePoint Sphere::sample(const Vec2& u) const {
  // cos θ = 2 u.y − 1 by Archimedes' theorem; as an arc sine, v keeps its digits at both poles.
  return at({u.x, 2 / pi_d * std::asin(std::sqrt(static_cast<double>(u.y)))});
}

// The quadratic is solved from the point q nearest to the centre. Fused multiply-adds find q to the last
// digit however far the ray's origin is, and from there nothing cancels: the perpendicular distance decides.
std::optional<double> Sphere::intersect(const Vec3d& o, const Vec3d& d, double t_min, double t_max) const {
  const double dd = dot(d, d);
  const double t_q = -dot(o, d) / dd;
  const Vec3d q(std::fma(t_q, d.x, o.x), std::fma(t_q, d.y, o.y), std::fma(t_q, d.z, o.z));
  const double b = dot(q, d);  // 0 but for the rounding of t_q
  const double discriminant = b * b + dd * (1 - dot(q, q));
  if (!(discriminant >= 0)) return std::nullopt;
  const double root = std::sqrt(discriminant);
  for (const double t : {t_q - (b + root) / dd, t_q - (b - root) / dd})
    if (t > t_min && t < t_max) return t;
  return std::nullopt;
}

}  // namespace umbral
