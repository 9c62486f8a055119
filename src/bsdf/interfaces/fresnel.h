// Reflection and refraction at smooth interfaces.
#pragma once

#include <optional>

#include "core/spectrum.h"

namespace umbral {

// Share of unpolarised light that the smooth interface between dielectrics reflects. cos_i ≥ 0 is on the side that
// the light comes from, eta = index beyond / index before. 1 at total internal reflection. In the form of
// Cook and Torrance [1982], g² = eta² − 1 + cos_i², whose differences keep their digits as eta goes to 1.
float fresnel_dielectric(float cos_i, float eta);

// `w`, away from the surface and with w.z ≥ 0, refracted to the side z < 0 (Snell's law); eta as above. None at
// total internal reflection.
std::optional<Vec3> refracted(const Vec3& w, float eta);

// The same at a metal of complex index eta + i k, over that of the medium before it, channel by channel
// [Born and Wolf 1999, §14.2].
Spectrum fresnel_conductor(float cos_i, const Spectrum& eta, const Spectrum& k);

// Schlick's approximation for a metal that reflects `f0` at normal incidence, tinted towards the edge
// [Kutz et al. 2021]: F = f0 + (1 − f0)(1 − c)⁵ − a c (1 − c)⁶, with a such that at c = 1/7 (82°) it is `edge_tint`
// times what Schlick [1994] alone would give. 1 at all angles where f0 and edge_tint are.
Spectrum fresnel_schlick(float cos_i, const Spectrum& f0, const Spectrum& edge_tint);
// 2 ∫ F c dc of it.
Spectrum fresnel_schlick_average(const Spectrum& f0, const Spectrum& edge_tint);

}  // namespace umbral
