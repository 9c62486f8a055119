// Warnings of what is legal but doubtful in a scene, and errors of numbers that nothing can be computed with.
#pragma once

#include "formats/assembly/scene_builder.h"

namespace umbral {

// No light; camera inside a closed shape; dielectrics that are not closed; materials whose parts reflect more
// than all; emitters that emit nothing or are not opaque; shapes so far from the origin that float cannot
// tell their detail. Errors: places, lenses and instances beyond what rays can be traced with, and light brighter than can
// be added up (number_checks.h). To the builder's diagnostics; `place` is that of the scene as a whole.
void check_scene(SceneBuilder& scene, const Place& place);

}  // namespace umbral
