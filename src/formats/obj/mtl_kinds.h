// What an MTL material is of.
#pragma once

#include "formats/obj/mtl_reader.h"

namespace umbral {

enum class MtlKind { glass, mirror, physical, glossy, matte };

// As mtl_materials.h tells.
MtlKind kind_of(const MtlMaterial& mtl);

// d, or 1 − Tr.
float opacity(const MtlMaterial& mtl);

}  // namespace umbral
