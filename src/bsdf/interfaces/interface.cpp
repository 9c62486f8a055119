// Tints and films of interfaces.
#include "bsdf/interfaces/interface.h"

namespace umbral {

Spectrum Interface::tinted(float share, float whole) const {
  const float plain_f0 = f0();
  const Spectrum tinted_f0 = glm::min(white, specular_color * plain_f0);
  const float rise = std::max(0.0f, share - plain_f0 * whole) / (1 - plain_f0);
  return specular * (tinted_f0 * whole + (white - tinted_f0) * rise);
}

Spectrum Interface::reflectance(float cos_outside) const {
  const float plain = std::min(1.0f, fresnel_dielectric(cos_outside, eta));
  const Spectrum bare = is_tinted() ? tinted(plain) : grey(plain);
  if (!film.exists()) return bare;
  const Spectrum with_film = film_reflectance(cos_outside, film, grey(eta), black);
  const Spectrum tint = is_tinted() ? bare / std::max(plain, 1e-9f) : white;
  return glm::mix(bare, glm::min(white, with_film * tint), film_share);
}

Spectrum Interface::reflectance_from(bool outside, float cos_i) const {
  if (is_plain()) return grey(std::min(1.0f, fresnel_dielectric(cos_i, outside ? eta : 1 / eta)));
  if (outside) return reflectance(cos_i);
  const float sin2_outside = sqr(eta) * (1 - cos_i) * (1 + cos_i);
  return sin2_outside >= 1 ? white : reflectance(std::sqrt(1 - sin2_outside));
}

}  // namespace umbral
