// Where the image of a light is turned to.
#pragma once

#include <optional>

#include "core/math.h"
#include "scene/transform.h"

namespace umbral {

// Takes directions in the world to those of a light that stands in it by that map; orthonormal, mirroring or not. None where
// the map stretches or shears, beyond a common scale.
std::optional<Mat3> light_from_world(const Affine& light_to_world);

}  // namespace umbral
