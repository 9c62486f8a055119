// Scenes for the tests of the renderer.
#pragma once

#include "scene/scene.h"

namespace umbral::test {

// One of everything, `scale` times as large as the first: mesh, sphere, disk, torus, box, rectangle light, emitting
// sphere, instances, textures, glass, mirror, alpha, a thin lens, and every kind of light.
SceneDescription everything(float scale);

// A room with a lamp in its ceiling, coloured side walls and two blocks.
SceneDescription cornell_room();

// The inside of a sphere with textured albedo and emission.
SceneDescription textured_sphere_interior();

// Shiny and matte things on a floor under a varied sky and a small sphere light.
SceneDescription open_air();

}  // namespace umbral::test
