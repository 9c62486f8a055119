// Look-up and importance sampling of the environment.
#include "scene/lights/environment.h"

#include "core/warp.h"

namespace umbral {

void EnvironmentLight::prepare() {
  factor_ = radiance * std::exp2(exposure);
  if (!image) return;
  directions_ = std::make_shared<SphereDistribution>(*image, mapping);
  const double turn = glm::radians(static_cast<double>(rotation));
  const Vec3 x(Vec3d(std::cos(turn), 0, std::sin(turn))), z(Vec3d(-std::sin(turn), 0, std::cos(turn)));
  to_image_ = image_from_world.value_or(Mat3(x, Vec3(0, 1, 0), z));
}

Spectrum EnvironmentLight::emitted(const Vec3& direction) const {
  if (!image) return factor_;
  return factor_ * seen_along(*image, mapping, to_image_ * direction) * rgb(1, 1, 1);
}

std::optional<LightSample> EnvironmentLight::sample(const Vec2& u) const {
  if (!image) return LightSample{square_to_sphere(u), factor_, sphere_pdf};
  const Vec3 wi = transpose(to_image_) * directions_->sample(u);
  const float density = pdf(wi);
  if (!(density > 0)) return std::nullopt;
  return LightSample{wi, emitted(wi), density};
}

float EnvironmentLight::pdf(const Vec3& direction) const {
  return image ? directions_->pdf(to_image_ * direction) : sphere_pdf;
}

double EnvironmentLight::power(double scene_radius) const {
  const double mean = luminance(factor_) * (directions_ ? directions_->mean_luminance() : 1);
  return 4 * pi_d * pi_d * sqr(scene_radius) * mean;
}

}  // namespace umbral
