// Central projection onto a slide.
#include "scene/lights/slide.h"

namespace umbral {

Slide::Slide(const Vec3d& axis, const Vec3d& up, double angle, double aspect, bool mirrored)
    : axis_(glm::normalize(axis)),
      right_(glm::normalize(cross(axis_, up)) * (mirrored ? -1.0 : 1.0)),
      up_(glm::normalize(up - dot(up, axis_) * axis_)) {
  const double shorter = std::tan(angle / 2);
  half_ = {shorter * std::max(aspect, 1.0), shorter / std::min(aspect, 1.0)};
}

Spectrum Slide::towards(const TextureImage& image, const Vec3& direction) const {
  const Vec3d d(direction);
  const double ahead = dot(d, axis_);
  if (!(ahead > 0)) return black;
  const glm::dvec2 place = glm::dvec2(dot(d, right_), dot(d, up_)) / (ahead * half_);
  if (!(std::max(std::abs(place.x), std::abs(place.y)) <= 1)) return black;
  return image.bilinear(Vec2(place * 0.5 + 0.5), Wrap::clamp) * rgb(1, 1, 1);
}

// dω = cos³ dA one unit ahead.
Slide::Texel Slide::texel(const TextureImage& image, int x, int y) const {
  const glm::dvec2 size(image.width(), image.height());
  const glm::dvec2 place = half_ * (2.0 * (glm::dvec2(x, y) + 0.5) / size - 1.0);
  const Vec3d through = axis_ + place.x * right_ + place.y * up_;
  const double length = glm::length(through);
  return {Vec3(through / length), 4 * half_.x * half_.y / (size.x * size.y * length * length * length)};
}

}  // namespace umbral
