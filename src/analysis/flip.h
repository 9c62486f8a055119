// FLIP: the difference that is perceived when two images are shown in turn [Andersson et al. 2020].
#pragma once

#include "analysis/convolution.h"
#include "analysis/planes.h"

namespace umbral {

// Pixels per degree of a 0.7 m wide display of 3840 pixels, seen from 0.7 m: the authors' default.
inline constexpr double flip_pixels_per_degree = 3840 * pi_d / 180;

// LDR-FLIP per pixel, in [0, 1]. Both images have one size and are *linear* RGB within [0, 1], as a display shows them
// once they are tone-mapped; they are not rounded to 8 bits.
Plane flip(const Planes& reference, const Planes& test, double pixels_per_degree = flip_pixels_per_degree);

// Over all pixels.
double mean(const Plane& plane);

}  // namespace umbral
