// Fresnel's equations and Snell's law.
#include "bsdf/interfaces/fresnel.h"

namespace umbral {
namespace {

float fifth_power(float x) { return sqr(sqr(x)) * x; }

// a of fresnel_schlick().
Spectrum edge_fall(const Spectrum& f0, const Spectrum& edge_tint) {
  const float c = 1.0f / 7, rest = 1 - c;
  const Spectrum schlick = f0 + (white - f0) * fifth_power(rest);
  return schlick * (white - edge_tint) / (c * fifth_power(rest) * rest);
}

}  // namespace

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

Spectrum fresnel_conductor(float cos_i, const Spectrum& eta, const Spectrum& k) {
  const float c2 = cos_i * cos_i, s2 = std::max(0.0f, 1 - c2);
  const Spectrum t0 = eta * eta - k * k - s2;
  const Spectrum a2_plus_b2 = glm::sqrt(t0 * t0 + 4.0f * k * k * eta * eta);
  const Spectrum t1 = a2_plus_b2 + c2;
  const Spectrum t2 = 2 * cos_i * glm::sqrt(glm::max(Spectrum(0.0f), 0.5f * (a2_plus_b2 + t0)));
  const Spectrum rs = (t1 - t2) / glm::max(t1 + t2, Spectrum(1e-30f));
  const Spectrum t3 = c2 * a2_plus_b2 + s2 * s2;
  const Spectrum t4 = t2 * s2;
  const Spectrum rp = rs * (t3 - t4) / glm::max(t3 + t4, Spectrum(1e-30f));
  return glm::clamp(0.5f * (rs + rp), 0.0f, 1.0f) * rgb(1, 1, 1);
}

Spectrum fresnel_schlick(float cos_i, const Spectrum& f0, const Spectrum& edge_tint) {
  const float m = glm::clamp(1 - cos_i, 0.0f, 1.0f), m5 = fifth_power(m);
  return glm::max(black, f0 + (white - f0) * m5 - edge_fall(f0, edge_tint) * (cos_i * m5 * m));
}

Spectrum fresnel_schlick_average(const Spectrum& f0, const Spectrum& edge_tint) {
  return glm::max(black, f0 + (white - f0) / 21.0f - edge_fall(f0, edge_tint) / 126.0f);
}

}  // namespace umbral
