// Fuzz on surfaces: the sheen of velvet and dust, from fibres that stand up.
#pragma once

#include "core/math.h"

namespace umbral {

// f = D G with the distribution D(θ) = (2 + 1/alpha) sin^{1/alpha} θ/(2π) of fibres and its fitted shadowing
// G = 1/((1 + Λ(wo) + Λ(wi)) 4 cos θo cos θi) [Estevez and Kulla 2017]; alpha is roughness². The fit makes energy near the
// horizon where alpha < 0.07: there f is divided by the larger of what both directions would reflect, if that is above 1.
struct Fuzz {
  // Fibres that stand up straighter are drawn as these: the sheen would be a line at the horizon.
  static constexpr float smallest_alpha = 0.01f;

  float alpha;

  static Fuzz of_roughness(float roughness) { return {std::max(sqr(roughness), smallest_alpha)}; }

  // f |cos θi|; directions with z ≥ 0.
  float f_cos(const Vec3& o, const Vec3& i) const;

  // Fuzz reflects so widely that directions are drawn evenly over the hemisphere.
  static Vec3 sample(const Vec2& u) {
    const float r = safe_sqrt((1 - u.x) * (1 + u.x)), phi = two_pi * u.y;
    return {r * std::cos(phi), r * std::sin(phi), u.x};
  }
  static constexpr float sample_pdf() { return 1 / two_pi; }

  // E: the share of light from an angle that it reflects (within 0.003), and the mean over the hemisphere.
  float albedo(float cos_theta) const;
  float average_albedo() const;
  // Of E, and of 1 − s E, as in Spread: how they lean towards the horizon.
  float lean() const;
  float lean_of_passed(float strength) const;
};

}  // namespace umbral
