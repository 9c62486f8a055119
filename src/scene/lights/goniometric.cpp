// Samples of goniometric lights.
#include "scene/lights/goniometric.h"

namespace umbral {

Spectrum GoniometricLight::intensity_towards(const Vec3& direction) const {
  const Vec3 down = glm::normalize(axis), forward = glm::normalize(front - dot(front, down) * down);
  const Vec3 right = cross(forward, down);
  const float along = dot(direction, down), across = dot(direction, right), ahead = dot(direction, forward);
  const float u = std::atan2(across, ahead) / two_pi + 0.5f;
  const float half_texel = 0.5f / static_cast<float>(image->height());
  const float v = std::atan2(std::hypot(across, ahead), along) * inverse_pi;
  // The image repeats around the axis but ends at the poles.
  const Spectrum value = image->bilinear({u, glm::clamp(v, half_texel, 1 - half_texel)}, Wrap::repeat);
  return intensity * value * rgb(1, 1, 1);
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
  for (int y = 0; y < height; ++y) {
    const double sine = std::sin(pi_d * (y + 0.5) / height);
    for (int x = 0; x < width; ++x) sum += luminance(intensity * image->texel(x, y)) * sine;
  }
  return sum * 2 * pi_d * pi_d / (static_cast<double>(width) * height);
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
