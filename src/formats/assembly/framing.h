// A camera and a light for files that bring none.
#pragma once

#include <optional>

#include "formats/assembly/scene_builder.h"

namespace umbral {

// Looks along −z at the middle of the box, so that its front face fills most of the image; at a box that lies flat from
// above, at one that stands edge-on from the right. `aspect` is width over height.
CameraSettings framing_camera(const Bounds& bounds, double aspect);

// Light for models that bring none: grey, dark below the horizon, with a wide window above to the left in front, so that
// shapes and gloss can be told.
EnvironmentLight neutral_sky();

// Gives the scene that camera if it has none of its own, and that sky if it has no light, unless `brightest_label` is none:
// surfaces that emit no more than that, in any channel, are not lamps. Both are told as warnings at `place`.
void complete_scene(SceneBuilder& scene, double aspect, const Place& place,
                    std::optional<float> brightest_label);

}  // namespace umbral
