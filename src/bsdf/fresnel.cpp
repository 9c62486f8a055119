// Fresnel's equations and Snell's law.
#include "bsdf/fresnel.h"

namespace umbral {

float fresnel_dielectric(float cos_i, float eta) {
  const float eta2_minus_1 = (eta - 1) * (eta + 1);
  const float g2 = eta2_minus_1 + cos_i * cos_i;
  if (g2 <= 0) return 1;
  const float g = std::sqrt(g2);
  const float g_minus_c = eta2_minus_1 / (g + cos_i);
  const float g_plus_c = g + cos_i;
  const float a = g_minus_c / g_plus_c;
  const float b = (cos_i * g_plus_c - 1) / (cos_i * g_minus_c + 1);
  return 0.5f * a * a * (1 + b * b);
}

std::optional<Vec3> refracted(const Vec3& w, float eta) {
  const float sin2_t = (w.x * w.x + w.y * w.y) / (eta * eta);
  if (sin2_t >= 1) return std::nullopt;
  return Vec3{-w.x / eta, -w.y / eta, -std::sqrt(1 - sin2_t)};
}

}  // namespace umbral
