// Textures of other numbers: a function of what a texture gives.
#pragma once

#include "formats/assembly/scene_builder.h"

namespace umbral {

// A texture of map(x), where `texture` gives the number x to a parameter that takes one: at each texel of an image, between
// which it is interpolated, or in each square of a checkerboard. None for other kinds, and for images of many files.
std::optional<TextureId> mapped_texture(SceneBuilder& builder, TextureId texture, float (*map)(float));

}  // namespace umbral
