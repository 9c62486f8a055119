// Reflection and refraction at smooth interfaces.
#pragma once

#include <optional>

#include "core/math.h"

namespace umbral {

// Share of unpolarised light that the smooth interface between dielectrics reflects. cos_i ≥ 0 is on the side that
// the light comes from, eta = index beyond / index before. 1 at total internal reflection. In the form of
// Cook and Torrance [1982], g² = eta² − 1 + cos_i², whose differences keep their digits as eta goes to 1.
float fresnel_dielectric(float cos_i, float eta);

// `w`, away from the surface and with w.z ≥ 0, refracted to the side z < 0 (Snell's law); eta as above. None at
// total internal reflection.
std::optional<Vec3> refracted(const Vec3& w, float eta);

}  // namespace umbral
