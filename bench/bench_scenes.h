// The scenes that performance is measured on.
#pragma once

#include "scene/description.h"

namespace umbral::bench {

// The Cornell box of scenes/cornell-box.
SceneDescription cornell_box();

// A room like a box whose walls, floor and furniture are displaced grids of two million triangles in all, each
// with an image texture of its own.
SceneDescription textured_room();

// A thousand instances of one shape of a hundred thousand triangles, under an area light and a constant sky.
SceneDescription instanced_field();

}  // namespace umbral::bench
