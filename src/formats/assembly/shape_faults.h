// What makes a shape impossible to render: no area, no direction, numbers beyond float.
#pragma once

#include <optional>
#include <string>

#include "scene/shapes/shapes.h"

namespace umbral {

struct ShapeFault {
  const char* key;  // the parameter to blame
  std::string message;
};

// The first fault of the shape as it stands, its transform included.
std::optional<ShapeFault> fault_of(const Shape& shape);

}  // namespace umbral
