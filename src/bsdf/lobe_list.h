// The closed list of lobes (their names: core/kinds.h). A new one is its own file in lobes/, a name here and an include in lobes.h.
#pragma once

#include <variant>

namespace umbral {

using Lobes =
    std::variant<struct Lambert, struct BlinnPhong, struct Mirror, struct Dielectric, struct Conductor,
                 struct Plastic, struct ThinDielectric, struct DiffuseTransmission, struct Principled,
                 struct Sheen, struct Coat, struct Mix>;

}  // namespace umbral
