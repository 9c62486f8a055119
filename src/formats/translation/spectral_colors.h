// Colours of spectra that are given by wavelengths or by a temperature.
#pragma once

#include <functional>

#include "core/spectrum.h"

namespace umbral {

// A spectrum by wavelength in nanometres; any unit.
using SpectralCurve = std::function<double(double nanometres)>;

// The linear RGB of light of that spectrum, scaled to luminance 1: CIE 1931 colour matching at every 10 nm of 380 … 780.
// Light outside the gamut has negative components, which become 0 without change of the luminance. Black where there is
// no light.
Spectrum light_color(const SpectralCurve& spectrum);

// The linear RGB of light of that spectrum, of which a flat one of 1 has luminance 1; negative components become 0.
Spectrum emission_color(const SpectralCurve& spectrum);

// That of a black body [Planck 1901], with luminance 1; kelvin > 0.
Spectrum black_body_color(double kelvin);

// The linear RGB of a surface of that reflectance in daylight D65, so that 1 everywhere is white.
Spectrum reflectance_color(const SpectralCurve& reflectance);

}  // namespace umbral
