// The closed list of lights as a scene samples them.
#pragma once

#include <variant>

#include "scene/lights/area.h"
#include "scene/lights/distant.h"
#include "scene/lights/environment.h"
#include "scene/lights/goniometric.h"
#include "scene/lights/light_chooser.h"
#include "scene/lights/point.h"
#include "scene/lights/spot.h"

namespace umbral {

using Light =
    std::variant<PointLight, SpotLight, DistantLight, GoniometricLight, AreaLight, EnvironmentLight>;

}  // namespace umbral
