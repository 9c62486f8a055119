// Photometric files of luminaires, LM-63 of the Illuminating Engineering Society ("IES profiles"), as images of intensity.
#pragma once

#include <memory>
#include <string>

#include "image/texture_image.h"

namespace umbral {

// Of the text of a file, 1986 to 2002: the image of a GoniometricLight, equirectangular, in W/sr where the file counts
// candelas, 179 lm to the watt. Vertical angle 0 is the bottom row; horizontal angle 0 is the middle column, and they grow
// counter-clockwise seen from above a lamp that hangs, to the right. Between the angles of the file it is linear, beyond its
// vertical ones 0. Type C alone, without a TILT of its own file; throws SceneError, located in `name`, on all else.
TextureImage luminaire_image(std::string text, const std::string& name);

}  // namespace umbral
