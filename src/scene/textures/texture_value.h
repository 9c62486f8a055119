// What a texture gives: a colour with alpha, of which a parameter may take one number, between known bounds.
#pragma once

#include <array>

#include "core/parameters.h"
#include "core/spectrum.h"

namespace umbral {

// Which number a texture gives to a parameter that takes one number.
enum class TextureChannel { luminance, r, g, b, a };

template <>
struct EnumNames<TextureChannel> {
  static constexpr std::array names{"luminance", "r", "g", "b", "a"};
};

// The lowest and highest value of each of r, g, b, a.
struct TextureBounds {
  Spectrum low, high;
};

}  // namespace umbral
