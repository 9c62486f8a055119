// Samples of distant lights.
#include "scene/lights/distant.h"

namespace umbral {

std::optional<LightSample> DistantLight::sample(const Vec3&) const {
  return LightSample{-Vec3(glm::normalize(Vec3d(direction))), irradiance, 1, true};
}

}  // namespace umbral
