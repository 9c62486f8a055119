// FilmImage to and from OpenEXR.
#pragma once

#include <string>

#include "image/exr.h"
#include "image/film_image.h"

namespace umbral {

// Channels, all 32-bit float: `R G B` (mean), `stderr.R/G/B`, `samples.Y`, `firefly.Y` (1 or 0, given four
// replicates), on request `stderrPooled.R/G/B`, `<layer>.R/G/B`, and with auxiliary features `albedo.R/G/B`, `N.X/Y/Z`, `Z`. Attributes: the provenance, error and rejected samples
// under the prefix `umbral:`, and pbrt's `renderTimeSeconds` and `samplesPerPixel`. Seeds are text: they have
// 64 bits.
ExrImage to_exr(const FilmImage& image);

// The way back; `file` is for error messages. Throws SceneError if the image was not written by umbral or
// lacks a channel.
FilmImage film_image(const ExrImage& exr, const std::string& file);

// write_exr(to_exr(image)) and its inverse, with their errors.
void write_film(const std::string& path, const FilmImage& image);
FilmImage read_film(const std::string& path);

}  // namespace umbral
