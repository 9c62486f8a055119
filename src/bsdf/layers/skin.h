// A clear dielectric skin over something else: what it reflects, smooth or by GGX facets, and how much that is.
#pragma once

#include "bsdf/bsdf.h"
#include "bsdf/facets/microfacet.h"
#include "bsdf/interfaces/interface.h"

namespace umbral {

// Directions have z ≥ 0. What single bounces off the skin lose goes on to what is under it, as its transmission does.
struct Skin {
  Interface interface;
  Ggx ggx;

  bool is_smooth() const { return std::max(ggx.alpha_x, ggx.alpha_y) < Ggx::smallest_alpha; }
  // The width of a surface without stretch that is about as rough.
  float round_alpha() const { return std::sqrt(ggx.alpha_x * ggx.alpha_y); }

  // R: the share of light from a direction that is reflected in all (within 0.003; 0.01 where it is tinted, stretched
  // or has a film), and its mean over the hemisphere. Of a cosine alone if stretched: at the azimuth where it is wider.
  Spectrum albedo(const Vec3& w) const;
  Spectrum albedo(float cos_theta) const { return albedo({0, 0, cos_theta}); }
  Spectrum average_albedo() const;
  // Of 1 − R, as in Spread: how what passes leans towards the horizon.
  float lean_of_passed() const;

  // f |cos θi|, and sampling by visible normals: the density, and the direction that u gives, none below the horizon.
  // Nothing for a smooth one.
  Spectrum f_cos(const Vec3& o, const Vec3& i) const;
  float pdf(const Vec3& o, const Vec3& i) const { return is_smooth() ? 0.0f : ggx.reflection_pdf(o, i); }
  std::optional<Vec3> sample(const Vec3& o, const Vec2& u) const { return ggx.sample_reflection(o, u); }

 private:
  Ggx rough_facets() const;  // as wide as tables reach at least
};

// What a diffuse body of reflectance ρ sends through a skin in both directions [Kelemen and Szirmay-Kalos 2001]:
//   f |cos θi| = ρ (1 − R(wo)) (1 − R(wi)) cos θi/(π (1 − R_avg)), which with ρ = 1 gives back all that R leaves.
Spectrum body_f_cos(const Spectrum& reflectance, const Spectrum& skin_o, const Spectrum& skin_i,
                    const Spectrum& skin_average, float cos_i);

// The chance to sample a skin, in proportion to what it reflects, but never all of it while there is a body.
float skin_probability(const Spectrum& skin, const Spectrum& body);

}  // namespace umbral
