// Spectra of pbrt files as linear RGB.
#pragma once

#include "core/spectrum.h"
#include "formats/pbrt/parameters.h"

namespace umbral::pbrt_file {

// Parameters of these types hold a spectrum.
inline constexpr std::initializer_list<const char*> spectrum_types{"rgb", "blackbody", "spectrum"};

// The colour of a surface, in [0, 1].
Spectrum albedo(SceneBuilder& builder, const Parameters& parameters, const std::string& name,
                const Spectrum& otherwise);
// Of a light before its scale: RGB as it stands, any other spectrum with luminance 1, as pbrt-v4 scales them.
Spectrum light(SceneBuilder& builder, const Parameters& parameters, const std::string& name);
// The mean of 1 value for each of r, g and b, as of an index of refraction or an absorption.
std::optional<Spectrum> unbounded(SceneBuilder& builder, const Parameters& parameters,
                                  const std::string& name);
// An index of refraction: a float, or a glass by its name, whose index at 587.6 nm is taken.
double index_of_refraction(SceneBuilder& builder, const Parameters& parameters, const std::string& name,
                           double otherwise);

// The colour of an albedo parameter that is there.
Spectrum albedo_of(SceneBuilder& builder, const Parameters& parameters, const Parameter& parameter);

}  // namespace umbral::pbrt_file
