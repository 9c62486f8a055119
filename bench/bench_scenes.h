// The scenes that performance is measured on.
#pragma once

#include "scene/description.h"

namespace umbral::bench {

// The Cornell box of scenes/cornell-box.
SceneDescription cornell_box();

// A room like a box, of few triangles, with two balls and a 2048² image texture on each of the eight shapes.
SceneDescription textured_box();

// The same room with walls and balls that are displaced grids of two million triangles in all, and textures of 1024².
SceneDescription textured_room();

// A thousand instances of one shape of a hundred thousand triangles, under an area light and a constant sky.
SceneDescription instanced_field();

// A hall of four rooms under ten thousand small lights: spheres, panels, points and spots, with powers over two decades.
SceneDescription hall_of_lights();

}  // namespace umbral::bench
