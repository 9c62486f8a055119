// Colours and indices of Mitsuba files.
#pragma once

#include "formats/mitsuba/properties.h"

namespace umbral::mitsuba_file {

// Whether the element holds a colour: <rgb>, <spectrum> or <float>.
bool is_color(const Element& element);

// As Mitsuba's RGB modes take them: RGB as it stands, tabulated spectra by the CIE 1931 observer, those of light as they
// are and those of surfaces in daylight D65, cut to 0 … 1.
Spectrum surface_color(SceneBuilder& builder, const Element& element);
Spectrum light_color(SceneBuilder& builder, const Element& element);
// Of light, or `otherwise` where there is none of that name.
Spectrum light_color(SceneBuilder& builder, const Properties& properties, const std::string& name,
                     const Spectrum& otherwise);
// An index or absorption in each of r, g and b.
Spectrum unbounded_color(SceneBuilder& builder, const Element& element);

// int_ior over ext_ior, which are numbers or names of materials.
float relative_index(SceneBuilder& builder, const Properties& properties, const char* usual_inside);

}  // namespace umbral::mitsuba_file
