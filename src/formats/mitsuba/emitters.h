// The emitters of a Mitsuba file that are no shapes.
#pragma once

#include "formats/mitsuba/textures.h"

namespace umbral::mitsuba_file {

void add_emitter(SceneBuilder& builder, const Document& document, const Element& emitter);

}  // namespace umbral::mitsuba_file
