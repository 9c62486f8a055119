// The shares of light that skins reflect, from the tables of plain interfaces.
#include "bsdf/layers/skin.h"

#include "bsdf/facets/microfacet_albedo.h"
#include "bsdf/facets/stretched_albedo.h"

namespace umbral {
namespace {

// The cosine at which the plain interface reflects the share r, about: from Schlick's approximation.
float cosine_of_share(float r, float f0) {
  return 1 - std::pow(glm::clamp((r - f0) / (1 - f0), 0.0f, 1.0f), 0.2f);
}

}  // namespace

Ggx Skin::rough_facets() const {
  return {std::max(ggx.alpha_x, Ggx::smallest_alpha), std::max(ggx.alpha_y, Ggx::smallest_alpha)};
}

// A film's colours at a rough surface are those at the angle at which a smooth one would reflect as much.
Spectrum Skin::albedo(const Vec3& w) const {
  if (is_smooth()) return interface.reflectance(w.z);
  const Ggx facets = rough_facets();
  const float plain = facets.is_round() ? interface_shares(w.z, facets.alpha_x, interface.eta).reflected
                                        : stretched_reflected(facets, w, interface.eta);
  if (interface.is_plain()) return grey(plain);
  const float whole = 1 - ggx_loss(facets, w);
  if (!interface.film.exists()) return glm::min(white, interface.tinted(plain, whole));
  return whole * interface.reflectance(cosine_of_share(plain / whole, interface.f0()));
}

// With a film by Gauss's rule with three points over cos² θ, of stretched facets at three azimuths.
Spectrum Skin::average_albedo() const {
  const Ggx facets = rough_facets();
  if (interface.film.exists()) {
    const auto around = [&](float c) {
      if (facets.is_round()) return albedo(c);
      const float sine = safe_sqrt((1 - c) * (1 + c)), low = 0.25881905f, high = 0.96592583f;  // of 15°, 75°
      const auto at = [&](float x, float y) { return albedo(Vec3{sine * x, sine * y, c}); };
      return (at(high, low) + at(0.70710678f, 0.70710678f) + at(low, high)) / 3.0f;
    };
    return (5.0f * (around(0.33571068f) + around(0.94196515f)) + 8.0f * around(0.70710678f)) / 18.0f;
  }
  const float plain = facets.is_round() ? interface_averages(facets.alpha_x, interface.eta).reflected
                                        : stretched_average_reflected(facets, interface.eta);
  if (interface.is_plain()) return grey(plain);
  return interface.tinted(plain, 1 - ggx_average_loss(facets));
}

// The steepness of R falls from 2 as the skin gets rough, within a tenth.
float Skin::lean_of_passed() const {
  const float average = luminance(average_albedo());
  const float steepness = 2 / (1 + 0.8f * std::sqrt(round_alpha()));
  return (luminance(albedo(1)) - average) * steepness / std::max(1 - average, 1e-6f);
}

Spectrum Skin::f_cos(const Vec3& o, const Vec3& i) const {
  const Vec3 sum = o + i;
  const float length = glm::length(sum);
  if (is_smooth() || !(length > 1e-12f)) return black;
  return interface.reflectance(std::min(1.0f, 0.5f * length)) *
         (ggx.density(sum / length) * ggx.shadowed_cos(o, i));
}

Spectrum body_f_cos(const Spectrum& reflectance, const Spectrum& skin_o, const Spectrum& skin_i,
                    const Spectrum& skin_average, float cos_i) {
  const Spectrum through =
      (white - skin_o) * (white - skin_i) / glm::max(1.0f - skin_average, Spectrum(1e-6f));
  return reflectance * through * (inverse_pi * cos_i);
}

float skin_probability(const Spectrum& skin, const Spectrum& body) {
  const float from_skin = luminance(skin), beneath = luminance((white - skin) * body);
  return from_skin + beneath > 0 ? from_skin / (from_skin + beneath) : 0.5f;
}

}  // namespace umbral
