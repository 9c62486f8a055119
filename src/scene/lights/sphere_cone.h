// The unit sphere seen from a point outside: points of its near side, uniform in solid angle.
#pragma once

#include "core/math.h"

namespace umbral {

// All in double, where far and near spheres keep their digits: sin² of the cone's half angle is 1/d².
class SphereCone {
 public:
  // From p, |p| > 1.
  explicit SphereCone(const Vec3d& p) : distance2_(dot(p, p)) {
    const double sin2 = 1 / distance2_;
    one_minus_cos_ = sin2 / (1 + std::sqrt(1 - sin2));
    z_ = p / std::sqrt(distance2_);
  }

  // Per solid angle.
  double pdf() const { return 1 / (2 * pi_d * one_minus_cos_); }

  // The point where a direction uniform in the cone meets the sphere first. From the centre it is seen at the angle
  // α from p: cos α = sin²θ/sin θₘ + cos θ √(1 − sin²θ/sin²θₘ), the law of sines for θ at p.
  Vec3d sample(const Vec2& u) const {
    const double h = static_cast<double>(u.x) * one_minus_cos_;     // 1 − cos θ
    const double share2 = std::min(h * (2 - h) * distance2_, 1.0);  // sin²θ/sin²θₘ
    const double sin_max = 1 / std::sqrt(distance2_);
    const double cos_alpha = share2 * sin_max + (1 - h) * std::sqrt(1 - share2);
    const double sin_alpha = std::sqrt(std::max((1 - cos_alpha) * (1 + cos_alpha), 0.0));
    const double phi = 2 * pi_d * static_cast<double>(u.y);
    // A frame around z [Duff et al. 2017].
    const double sign = std::copysign(1.0, z_.z), a = -1 / (sign + z_.z), b = z_.x * z_.y * a;
    const Vec3d s{1 + sign * z_.x * z_.x * a, sign * b, -sign * z_.x}, t{b, sign + z_.y * z_.y * a, -z_.y};
    return glm::normalize(sin_alpha * std::cos(phi) * s + sin_alpha * std::sin(phi) * t + cos_alpha * z_);
  }

 private:
  double distance2_, one_minus_cos_;
  Vec3d z_;
};

}  // namespace umbral
