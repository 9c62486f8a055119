// Samples of goniometric lights.
#include "scene/lights/goniometric.h"

namespace umbral {

Mat3 GoniometricLight::to_image() const {
  if (image_from_world) return *image_from_world;
  const Vec3d down = glm::normalize(Vec3d(axis)),
              forward = glm::normalize(Vec3d(front) - dot(Vec3d(front), down) * down);
  return Mat3(transpose(glm::dmat3(cross(forward, down), -down, -forward)));
}

Spectrum GoniometricLight::intensity_towards(const Vec3& direction) const {
  return intensity * seen_along(*image, mapping, to_image() * direction) * rgb(1, 1, 1);
}

std::optional<LightSample> GoniometricLight::sample(const Vec3& p) const {
  const Vec3 to_light = position - p;
  const float distance = glm::length(to_light);
  if (!(distance > 0)) return std::nullopt;
  const Vec3 wi = to_light / distance;
  const Spectrum towards = intensity_towards(-wi);
  if (is_black(towards)) return std::nullopt;
  return LightSample{wi, towards / sqr(distance), 1, true, distance, position};
}

// ∫ I dω by the middles of the texels.
double GoniometricLight::power() const {
  double sum = 0;
  const int width = image->width(), height = image->height();
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) {
      const Vec2 middle((static_cast<float>(x) + 0.5f) / static_cast<float>(width),
                        (static_cast<float>(y) + 0.5f) / static_cast<float>(height));
      sum += static_cast<double>(luminance(intensity * image->texel(x, y)) *
                                 stretch_at(mapping, direction_of(mapping, middle)));
    }
  return sum / (static_cast<double>(width) * height);
}

// The brightest texel, everywhere: lights with narrow beams are asked more often than they deserve.
LightBounds GoniometricLight::bounds() const {
  double most = 0;
  for (int y = 0; y < image->height(); ++y)
    for (int x = 0; x < image->width(); ++x)
      most = std::max<double>(most, luminance(intensity * image->texel(x, y)));
  return bounds_of_point(Vec3d(position), most);
}

}  // namespace umbral
