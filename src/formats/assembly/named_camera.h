// Cameras that files bring under a name.
#pragma once

#include <string>

#include "scene/camera.h"

namespace umbral {

struct NamedCamera {
  std::string name;
  CameraSettings settings;
  float aspect = 0;  // width over height; 0 where the file leaves it open
};

}  // namespace umbral
