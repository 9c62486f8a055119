// Metals that reflect less than metals do, as some files have them.
#pragma once

#include "bsdf/lobes/conductor.h"

namespace umbral {

// Multiplies what the metal reflects by a tint: exactly at normal incidence and in the mean over the hemisphere.
void tint_metal(const Spectrum& tint, Conductor& lobe);

}  // namespace umbral
