// The last step of reading a shape: put it into its place, mend what can be mended and refuse what cannot.
#pragma once

#include "formats/assembly/scene_builder.h"
#include "formats/assembly/shape_faults.h"

namespace umbral {

// Bakes the transform of a mesh into its vertices, cleans it (repairs become a warning at `place`) and
// appends the shape. The fault, and nothing appended, where the shape cannot be rendered.
std::optional<ShapeFault> place_shape(Shape shape, const Place& place, Diagnostics& diagnostics,
                                      ShapeList& shapes);

}  // namespace umbral
