// Look-up and importance sampling of the environment.
#include "scene/lights/environment.h"

#include "core/warp.h"

namespace umbral {
namespace {

// Mean luminance of the 3 × 3 texels around (x, y): what a bilinear look-up within that cell may draw on.
double neighbourhood(const TextureImage& image, int x, int y) {
  double sum = 0;
  for (int dy = -1; dy <= 1; ++dy)
    for (int dx = -1; dx <= 1; ++dx) {
      const int column = (x + dx + image.width()) % image.width();
      const int row = std::clamp(y + dy, 0, image.height() - 1);
      sum += luminance(image.texel(column, row));
    }
  return sum / 9;
}

}  // namespace

// The distribution's rows run with v, from the bottom of the image (v = 0, −y) to its top.
void EnvironmentLight::prepare() {
  factor_ = std::exp2(exposure);
  mean_luminance_ = luminance(radiance * factor_);
  if (!image) return;
  const int width = image->width(), height = image->height();
  std::vector<double> weights;
  weights.reserve(static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
  double sines = 0;
  for (int row = 0; row < height; ++row) {
    const double sine = std::sin(pi_d * (row + 0.5) / height);
    sines += sine * width;
    for (int x = 0; x < width; ++x) weights.push_back(neighbourhood(*image, x, row) * sine);
  }
  texels_ = std::make_shared<Distribution2D>(weights, static_cast<std::size_t>(width),
                                             static_cast<std::size_t>(height));
  mean_luminance_ *= texels_->sum() / sines;
}

namespace {

// Of the angle between a unit vector and the y axis.
float sine_of(const Vec3& d) { return std::sqrt(d.x * d.x + d.z * d.z); }

}  // namespace

Vec2 EnvironmentLight::uv_of(const Vec3& d) const {
  const float azimuth = std::atan2(d.x, -d.z) / two_pi + 0.5f + rotation / 360;
  // By the arc tangent: near the poles the cosine alone has lost the angle.
  return {azimuth - std::floor(azimuth), 1 - std::atan2(sine_of(d), d.y) * inverse_pi};
}

Spectrum EnvironmentLight::emitted(const Vec3& direction) const {
  if (!image) return radiance * factor_;
  // The image repeats around the horizon but ends at the poles.
  Vec2 uv = uv_of(direction);
  const float half_texel = 0.5f / static_cast<float>(image->height());
  uv.y = glm::clamp(uv.y, half_texel, 1 - half_texel);
  return radiance * factor_ * image->bilinear(uv, Wrap::repeat) * rgb(1, 1, 1);
}

std::optional<LightSample> EnvironmentLight::sample(const Vec2& u) const {
  if (!image) return LightSample{square_to_sphere(u), radiance * factor_, sphere_pdf};
  const Distribution2D::Draw draw = texels_->sample(u);
  const float theta = pi * (1 - draw.position.y);
  const float phi = two_pi * (draw.position.x - 0.5f - rotation / 360);
  const float sine = std::sin(theta);
  const Vec3 wi{sine * std::sin(phi), std::cos(theta), -sine * std::cos(phi)};
  const float density = pdf(wi);
  if (!(density > 0)) return std::nullopt;
  return LightSample{wi, emitted(wi), density};
}

float EnvironmentLight::pdf(const Vec3& direction) const {
  if (!image) return sphere_pdf;
  const float sine = sine_of(direction);
  if (!(sine > 0)) return 0;
  return texels_->pdf(uv_of(direction)) / (2 * pi * pi * sine);
}

double EnvironmentLight::power(double scene_radius) const {
  return 4 * pi_d * pi_d * sqr(scene_radius) * mean_luminance_;
}

}  // namespace umbral
