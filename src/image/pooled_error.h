// The standard errors of pixels, steadied by their neighbours'.
#pragma once

#include <vector>

#include "image/film_image.h"

namespace umbral {

// √ of the mean squared standard error of the 5 × 5 pixels around each, fewer at the border, those that have samples
// and a known error. With 8 replicates the error of a pixel is itself uncertain by 27 %, this one by 5 %; the price is
// that it is the error of a neighbourhood, wrong where noise changes from pixel to pixel. Infinite where nothing is
// known.
std::vector<Vec3d> pooled_errors(const FilmImage& image);

}  // namespace umbral
