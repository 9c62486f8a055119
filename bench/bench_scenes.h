// The scenes that performance is measured on.
#pragma once

#include "scene/description.h"

namespace umbral::bench {

// The Cornell box of scenes/cornell-box.
SceneDescription cornell_box();

// On each of the eight shapes of the room below; a size of 0 for one grey instead.
struct RoomTextures {
  int size = 2048;
  TextureFilter filter = TextureFilter::bilinear;
};

// A room like a box, of few triangles, with two balls.
SceneDescription textured_box(const RoomTextures& textures = {});

// The same room with walls and balls that are displaced grids of two million triangles in all; its textures take 64 MiB
// unless said otherwise.
SceneDescription textured_room(const RoomTextures& textures = {1448});

// A thousand instances of one shape of a hundred thousand triangles, under an area light and a constant sky.
SceneDescription instanced_field();

// A hall of four rooms under ten thousand small lights: spheres, panels, points and spots, with powers over two decades.
SceneDescription hall_of_lights();

}  // namespace umbral::bench
