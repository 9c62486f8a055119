// Samples of spot lights.
#include "scene/lights/spot.h"

namespace umbral {

float SpotLight::falloff(float cos_angle) const {
  const float angle = glm::degrees(std::acos(glm::clamp(cos_angle, -1.0f, 1.0f)));
  if (angle >= cone_angle) return 0;
  const float width = std::min(edge_angle, cone_angle);
  if (angle <= cone_angle - width) return 1;
  const float t = (cone_angle - angle) / width;
  if (edge == SpotEdge::linear) return t;
  if (edge == SpotEdge::smooth) return t * t * (3 - 2 * t);
  const float end = std::cos(glm::radians(cone_angle)), full = std::cos(glm::radians(cone_angle - width));
  return glm::smoothstep(end, full, cos_angle);
}

std::optional<LightSample> SpotLight::sample(const Vec3& p) const {
  const Vec3 to_light = position - p;
  const float distance = glm::length(to_light);
  if (!(distance > 0)) return std::nullopt;
  const Vec3 wi = to_light / distance;
  const float share = falloff(dot(-wi, Vec3(glm::normalize(Vec3d(target) - Vec3d(position)))));
  if (share == 0) return std::nullopt;
  return LightSample{wi, intensity * (share / sqr(distance)), 1, true, distance, position};
}

LightBounds SpotLight::bounds() const {
  LightBounds bounds = bounds_of_point(Vec3d(position), luminance(intensity));
  const float width = std::min(edge_angle, cone_angle);
  bounds.normals = {glm::normalize(Vec3d(target) - Vec3d(position)),
                    glm::radians(static_cast<double>(cone_angle - width))};
  bounds.fade = glm::radians(static_cast<double>(width));
  return bounds;
}

double SpotLight::power() const {
  // ∫ falloff dω by Simpson's rule over the angle; it only weighs the choice among lights.
  constexpr int steps = 64;
  const double end = glm::radians(static_cast<double>(cone_angle));
  double sum = 0;
  for (int i = 0; i <= steps; ++i) {
    const double angle = end * i / steps;
    const double weight = i == 0 || i == steps ? 1 : (i % 2 == 1 ? 4 : 2);
    sum += weight * falloff(static_cast<float>(std::cos(angle))) * std::sin(angle);
  }
  return 2 * pi_d * luminance(intensity) * sum * end / steps / 3;
}

}  // namespace umbral
