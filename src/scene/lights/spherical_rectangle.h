// Rectangles seen from a point: their solid angle, and points on them that are uniform in it.
#pragma once

#include <array>

#include "core/math.h"

namespace umbral {

// All in double: the solid angle is the excess of four angles over 2π [Ureña et al. 2013].
class SphericalRectangle {
 public:
  // `x` and `y` are the unit directions of the two edges, `length` their lengths; seen from p.
  SphericalRectangle(const Vec3d& p, const Vec3d& corner, const Vec3d& x, const Vec3d& y,
                     const glm::dvec2& length) {
    const Vec3d d = corner - p;
    z_ = -std::abs(dot(d, cross(x, y)));
    low_ = {dot(d, x), dot(d, y)};
    high_ = low_ + length;
    length_ = length;
    // The z components of the unit normals of the planes through p and the edges y₀, x₁, y₁ and x₀.
    const double z2 = z_ * z_;
    const auto slope = [&](double at) { return at / std::sqrt(z2 + at * at); };
    const std::array<double, 4> n{-slope(low_.y), slope(high_.x), slope(high_.y), -slope(low_.x)};
    std::array<double, 4> angles{};
    for (std::size_t i = 0; i < 4; ++i) angles[i] = std::acos(std::clamp(-n[i] * n[(i + 1) % 4], -1.0, 1.0));
    b0_ = n[0];
    b1_ = n[2];
    k_ = 2 * pi_d - angles[2] - angles[3];
    solid_angle_ = angles[0] + angles[1] - k_;
  }

  // sr; NaN or without digits where the plane of the rectangle holds p.
  double solid_angle() const { return solid_angle_; }

  // Where along the edges, in [0, 1]².
  glm::dvec2 sample(const Vec2& u) const {
    // φᵤ, then xᵤ: which x leaves the share u.x of the solid angle behind.
    const double phi = static_cast<double>(u.x) * solid_angle_ + k_;
    const double f = (std::cos(phi) * b0_ - b1_) / std::sin(phi);
    const double c = std::clamp(std::copysign(1 / std::sqrt(f * f + b0_ * b0_), f), -1.0, 1.0);
    const double x = std::clamp(-c * z_ / std::sqrt(std::max(1 - c * c, 1e-300)), low_.x, high_.x);
    const double d2 = x * x + z_ * z_;
    const double h0 = low_.y / std::sqrt(d2 + low_.y * low_.y),
                 h1 = high_.y / std::sqrt(d2 + high_.y * high_.y);
    const double h = h0 + static_cast<double>(u.y) * (h1 - h0);
    const double y = std::clamp(h * std::sqrt(d2 / std::max(1 - h * h, 1e-300)), low_.y, high_.y);
    return glm::clamp((glm::dvec2(x, y) - low_) / length_, 0.0, 1.0);
  }

 private:
  glm::dvec2 low_, high_, length_;  // in the rectangle's own axes, p at the origin
  double z_, b0_, b1_, k_, solid_angle_;
};

}  // namespace umbral
