// The share of light that a smooth interface between dielectrics reflects: plain, tinted, or under a thin film.
#pragma once

#include "bsdf/interfaces/fresnel.h"
#include "bsdf/interfaces/thin_film.h"

namespace umbral {

// Fresnel's F for the index `eta` (inside over outside). It may be tinted as in glTF's KHR_materials_specular, where F
// goes from f₀ at normal incidence to `specular` at the horizon:
//   F = specular (f₀ + (1 − f₀) w),  f₀ = min(1, specular_color ((eta − 1)/(eta + 1))²),
// the weight w being that with which the untinted F, exact here instead of Schlick's, goes from its own f₀ to 1. A film
// on it is seen in the part `film_share`.
struct Interface {
  float eta = 1.5f;
  float specular = 1;
  Spectrum specular_color = white;
  ThinFilm film;
  float film_share = 1;

  bool is_tinted() const { return specular != 1 || specular_color != white; }
  bool is_plain() const { return !is_tinted() && !film.exists(); }

  float f0() const { return sqr((eta - 1) / (eta + 1)); }
  // `share` of the light is reflected untinted and without film, of which `whole` would be if F were 1.
  Spectrum tinted(float share, float whole = 1) const;

  // F for a cosine on the outer side.
  Spectrum reflectance(float cos_outside) const;
  // The same from either side; cos_i ≥ 0 is on the side that the light comes from.
  Spectrum reflectance_from(bool outside, float cos_i) const;
};

}  // namespace umbral
