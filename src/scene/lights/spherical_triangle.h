// Triangles seen from a point: their solid angle, and directions towards them that are uniform in it.
#pragma once

#include "core/math.h"

namespace umbral {

// All in double: the solid angle is the excess of three angles over π [Arvo 1995].
class SphericalTriangle {
 public:
  // Seen from p, which is none of the corners.
  SphericalTriangle(const Vec3d& p, const Vec3d& a, const Vec3d& b, const Vec3d& c)
      : a_(glm::normalize(a - p)), b_(glm::normalize(b - p)), c_(glm::normalize(c - p)) {
    const Vec3d ab = cross(a_, b_), bc = cross(b_, c_), ca = cross(c_, a_);
    alpha_ = angle(ab, -ca);
    solid_angle_ = alpha_ + angle(bc, -ab) + angle(ca, -bc) - pi_d;
  }

  // sr; without digits where it is below 1e-6 or close to a half sphere.
  double solid_angle() const { return solid_angle_; }

  // A direction from p, unit.
  Vec3d sample(const Vec2& u) const {
    // The arc a–c' cuts off the share u.x of the solid angle; the direction is on the arc b–c'.
    const double part = static_cast<double>(u.x) * solid_angle_ - alpha_;
    const double s = std::sin(part), t = std::cos(part);
    const double cos_alpha = std::cos(alpha_), sin_alpha = std::sin(alpha_);
    const double x = t - cos_alpha, y = s + sin_alpha * dot(a_, b_);
    const double below = (y * s + x * t) * sin_alpha;
    const double q = below != 0 ? std::clamp(((y * t - x * s) * cos_alpha - y) / below, -1.0, 1.0) : 1.0;
    const Vec3d c = q * a_ + std::sqrt(1 - q * q) * beside(c_, a_);
    const double z = 1 - static_cast<double>(u.y) * (1 - dot(c, b_));
    return z * b_ + std::sqrt(std::max(1 - z * z, 0.0)) * beside(c, b_);
  }

 private:
  static double angle(const Vec3d& m, const Vec3d& n) {
    return std::atan2(glm::length(cross(m, n)), dot(m, n));
  }
  // The unit part of v that is orthogonal to the unit vector `axis`; zero where there is none.
  static Vec3d beside(const Vec3d& v, const Vec3d& axis) {
    const Vec3d part = v - dot(v, axis) * axis;
    const double length = glm::length(part);
    return length > 0 ? part / length : Vec3d(0);
  }

  Vec3d a_, b_, c_;
  double alpha_, solid_angle_;
};

}  // namespace umbral
