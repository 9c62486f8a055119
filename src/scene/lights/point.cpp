// Samples of point lights.
#include "scene/lights/point.h"

namespace umbral {

std::optional<LightSample> PointLight::sample(const Vec3& p) const {
  const Vec3 to_light = position - p;
  const float distance = glm::length(to_light);
  if (!(distance > 0)) return std::nullopt;
  return LightSample{to_light / distance, intensity / sqr(distance), 1, true, distance, position};
}

}  // namespace umbral
