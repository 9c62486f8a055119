// The unit disk: placement, parametrisation and ray intersection.
#include "scene/shapes/disk.h"

#include "core/warp.h"
#include "scene/shapes/round.h"

namespace umbral {
namespace {

SurfacePoint point_of_disk(double cos_phi, double sin_phi, const glm::dvec2& uv) {
  const Vec3d outwards(cos_phi, sin_phi, 0);
  return {uv.y * outwards, {0, 0, 1}, uv, 2 * pi_d * uv.y * Vec3d(-sin_phi, cos_phi, 0), outwards};
}

}  // namespace

Affine Disk::placement() const {
  const Vec3d n = glm::normalize(Vec3d(normal));
  const auto [s, t] = axes_across(n);
  return {static_cast<double>(radius) * glm::dmat3(s, t, n), Vec3d(center)};
}

Bounds Disk::bounds() const { return {{-1, -1, 0}, {1, 1, 0}}; }

double Disk::area() const { return pi_d; }

SurfacePoint Disk::at(const glm::dvec2& uv) const {
  const double phi = 2 * pi_d * uv.x;
  return point_of_disk(std::cos(phi), std::sin(phi), uv);
}

SurfacePoint Disk::nearest(const Vec3d& p) const {
  const double r = std::hypot(p.x, p.y);
  const glm::dvec2 uv(turns_around_z(p), std::min(r, 1.0));
  return r > 0 ? point_of_disk(p.x / r, p.y / r, uv) : point_of_disk(1, 0, uv);
}

SurfacePoint Disk::sample(const Vec2& u) const {
  const Vec2 p = square_to_disk(u);
  return nearest({p.x, p.y, 0});
}

std::optional<double> Disk::intersect(const Vec3d& o, const Vec3d& d, double t_min, double t_max) const {
  const double t = -o.z / d.z;
  if (!(t > t_min && t < t_max)) return std::nullopt;
  const double x = std::fma(t, d.x, o.x), y = std::fma(t, d.y, o.y);
  if (!(x * x + y * y <= 1)) return std::nullopt;
  return t;
}

}  // namespace umbral
