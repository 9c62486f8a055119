// Puts the origin where the camera is, for scenes that stand far from it.
#pragma once

#include "scene/description.h"

namespace umbral {

/// The same scene moved by −camera.position, if that makes its largest coordinate smaller: single numbers are dense around
/// 0, and so error bounds, which grow with coordinates, are small near the viewer. A scene whose numbers are small as
/// they are stays as it is, to the bit: seen from afar, it would lose by being moved. So does one with a texture that lies
/// in the space of the world, which must not slide along with the camera.
///
/// Vertices in the world were rounded when they were read, to half an ulp of their coordinates; what is placed by a
/// transform, as instances are, has lost nothing yet.
SceneDescription relative_to_camera(SceneDescription scene);

}  // namespace umbral
