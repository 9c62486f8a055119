// Films as thin as light's waves are long: soap, oil, oxide on steel, and the colours of their interference.
#pragma once

#include "core/spectrum.h"

namespace umbral {

// A clear layer of one index and thickness. None where its thickness is 0.
struct ThinFilm {
  float eta = 1.3f;
  float thickness = 0;  // nm

  bool exists() const { return thickness > 0; }
};

// Share of unpolarised light from air that the film on a base of complex index eta + i k reflects, channel by channel.
// As the thickness goes to 0 it is what the bare base reflects. Colours outside of what red, green and blue can
// mix are cut off at their bounds 0 and 1.
Spectrum film_reflectance(float cos_i, const ThinFilm& film, const Spectrum& eta, const Spectrum& k);

// The real index of a dielectric that reflects `f0` at normal incidence.
Spectrum eta_of_reflectance(const Spectrum& f0);

}  // namespace umbral
