// Samples of distant lights.
#include "scene/lights/distant.h"

namespace umbral {

std::optional<LightSample> DistantLight::sample(const Vec3&) const {
  return LightSample{-glm::normalize(direction), irradiance, 1, true};
}

}  // namespace umbral
