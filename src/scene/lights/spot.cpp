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

Slide SpotLight::slide() const {
  const float angle = image_angle > 0 ? image_angle : 2 * cone_angle;
  const double aspect = image_aspect > 0 ? static_cast<double>(image_aspect)
                                         : static_cast<double>(image->width()) / image->height();
  return {axis(), Vec3d(up), glm::radians(static_cast<double>(angle)), aspect, image_mirrored};
}

std::optional<LightSample> SpotLight::sample(const Vec3& p) const {
  const Vec3 to_light = position - p;
  const float distance = glm::length(to_light);
  if (!(distance > 0)) return std::nullopt;
  const Vec3 wi = to_light / distance;
  const float share = falloff(dot(-wi, Vec3(axis())));
  if (share == 0) return std::nullopt;
  Spectrum irradiance = intensity * (share / sqr(distance));
  if (image) {
    irradiance *= slide().towards(*image, -wi);
    if (is_black(irradiance)) return std::nullopt;
  }
  return LightSample{wi, irradiance, 1, true, distance, position};
}

// Of the image, its brightest channels.
LightBounds SpotLight::bounds() const {
  const Spectrum most = image ? intensity * image->min_max().second : intensity;
  LightBounds bounds = bounds_of_point(Vec3d(position), luminance(most));
  const float width = std::min(edge_angle, cone_angle);
  bounds.normals = {axis(), glm::radians(static_cast<double>(cone_angle - width))};
  bounds.fade = glm::radians(static_cast<double>(width));
  return bounds;
}

double SpotLight::power_by_texels() const {
  const Slide slide = this->slide();
  const Vec3 along(axis());
  double sum = 0;
  for (int y = 0; y < image->height(); ++y)
    for (int x = 0; x < image->width(); ++x) {
      const double light = luminance(intensity * image->texel(x, y));
      if (!(light > 0)) continue;
      const auto [direction, solid_angle] = slide.texel(*image, x, y);
      sum += light * solid_angle * falloff(dot(direction, along));
    }
  return sum;
}

double SpotLight::power_by_directions() const {
  constexpr int rings = 64;
  const Slide slide = this->slide();
  const Frame frame = frame_from_normal(Vec3(axis()));
  const float step = glm::radians(cone_angle) / rings, turn = two_pi / rings;
  double sum = 0;
  for (int i = 0; i < rings; ++i)
    for (int j = 0; j < rings; ++j) {
      const float angle = step * (static_cast<float>(i) + 0.5f), phi = turn * static_cast<float>(j);
      const Vec3 local{std::sin(angle) * std::cos(phi), std::sin(angle) * std::sin(phi), std::cos(angle)};
      sum += luminance(intensity * slide.towards(*image, frame.to_world(local))) * falloff(local.z) *
             std::sin(angle);
    }
  return sum * step * turn;
}

double SpotLight::power() const {
  if (image) {
    const double by_texels = power_by_texels();
    return by_texels > 0 ? by_texels
                         : power_by_directions();  // of texels wider than the cone no middle may be in it
  }
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
