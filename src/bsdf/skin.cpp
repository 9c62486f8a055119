// The shares of light that skins reflect, from the tables of plain interfaces.
#include "bsdf/skin.h"

#include "bsdf/microfacet_albedo.h"

namespace umbral {
namespace {

// The cosine at which the plain interface reflects the share r, about: from Schlick's approximation.
float cosine_of_share(float r, float f0) {
  return 1 - std::pow(glm::clamp((r - f0) / (1 - f0), 0.0f, 1.0f), 0.2f);
}

}  // namespace

// A film's colours at a rough surface are those at the angle at which a smooth one would reflect as much.
Spectrum Skin::albedo(float cos_theta) const {
  if (is_smooth()) return interface.reflectance(cos_theta);
  const float alpha = std::max(round_alpha(), Ggx::smallest_alpha);
  const float plain = interface_shares(cos_theta, alpha, interface.eta).reflected;
  if (interface.is_plain()) return grey(plain);
  const float whole = 1 - ggx_loss({alpha, alpha}, {0, 0, cos_theta});
  if (!interface.film.exists()) return glm::min(white, interface.tinted(plain, whole));
  return whole * interface.reflectance(cosine_of_share(plain / whole, interface.f0()));
}

// With a film by Gauss's rule with three points over cos² θ.
Spectrum Skin::average_albedo() const {
  const float alpha = std::max(round_alpha(), Ggx::smallest_alpha);
  if (interface.film.exists())
    return (5.0f * (albedo(0.33571068f) + albedo(0.94196515f)) + 8.0f * albedo(0.70710678f)) / 18.0f;
  const float plain = interface_averages(alpha, interface.eta).reflected;
  if (interface.is_plain()) return grey(plain);
  return interface.tinted(plain, 1 - ggx_average_loss({alpha, alpha}));
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

std::optional<Vec3> Skin::sample(const Vec3& o, const Vec2& u) const {
  const Vec3 wi = reflected(o, ggx.sample_visible_normal(o, u));
  if (wi.z <= 0) return std::nullopt;
  return wi;
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
