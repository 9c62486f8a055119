// The box around a scene that is being read.
#pragma once

#include "formats/assembly/scene_builder.h"
#include "scene/shape_bounds.h"

namespace umbral {

// Around the whole scene, instances among it; low > high where it has no shape.
Bounds bounds_of(const SceneBuilder& scene);

}  // namespace umbral
