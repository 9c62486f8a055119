// Bounds around bounds.
#include "scene/lights/light_bounds.h"

namespace umbral {
namespace {

// What rounding may take from an angle; cones are opened by it, so that they never hold less than they say.
constexpr double angle_slack = 1e-6;

double angle_between(const Vec3d& a, const Vec3d& b) {
  return std::atan2(glm::length(cross(a, b)), dot(a, b));
}

}  // namespace

DirectionCone cone_around(const DirectionCone& a, DirectionCone b, bool two_sided) {
  if (two_sided && dot(a.axis, b.axis) < 0) b.axis = -b.axis;
  const double between = angle_between(a.axis, b.axis);
  if (std::min(between + b.angle, pi_d) <= a.angle) return a;
  if (std::min(between + a.angle, pi_d) <= b.angle) return b;
  const double angle = (a.angle + between + b.angle) / 2 + angle_slack;
  const Vec3d way = b.axis - dot(a.axis, b.axis) * a.axis;
  const double length = glm::length(way);
  // Of opposite axes the way between is lost to rounding.
  if (angle >= pi_d || !(length > 1e-6)) return {a.axis, pi_d};
  const double turn = angle - a.angle;
  return {glm::normalize(std::cos(turn) * a.axis + std::sin(turn) / length * way), angle};
}

LightBounds bounds_of_point(const Vec3d& p, double intensity) {
  LightBounds bounds;
  bounds.box = {p, p};
  bounds.intensity = intensity;
  return bounds;
}

LightBounds bounds_around(const LightBounds& a, const LightBounds& b) {
  if (!(a.intensity > 0)) return b;
  if (!(b.intensity > 0)) return a;
  LightBounds bounds;
  bounds.box = {glm::min(a.box.low, b.box.low), glm::max(a.box.high, b.box.high)};
  const Vec3d middle = bounds.middle();
  const double reach = std::max(glm::length(a.middle() - middle) + a.radius,  //
                                glm::length(b.middle() - middle) + b.radius);
  bounds.radius = std::min(reach, glm::length(bounds.box.high - bounds.box.low) / 2);
  bounds.normals = cone_around(a.normals, b.normals, a.two_sided && b.two_sided);
  bounds.fade = std::max(a.fade, b.fade);
  bounds.intensity = a.intensity + b.intensity;
  bounds.two_sided = a.two_sided || b.two_sided;
  return bounds;
}

double orientation_cost(const LightBounds& bounds) {
  if (!(bounds.intensity > 0)) return 0;
  const double normals = bounds.normals.angle, reach = std::min(normals + bounds.fade, pi_d);
  const double directions = 2 * pi_d * (1 - std::cos(normals)) +
                            pi_d / 2 *
                                (2 * reach * std::sin(normals) - std::cos(normals - 2 * reach) -
                                 2 * normals * std::sin(normals) + std::cos(normals));
  const Vec3d size = bounds.box.high - bounds.box.low;
  // Half of the box's surface, and enough of its length that lights in a row differ from lights at one point.
  const double area = size.x * size.y + size.y * size.z + size.z * size.x + 1e-3 * dot(size, size);
  return bounds.intensity * directions * area;
}

}  // namespace umbral
