// Indices into the lists of a scene, and the values that take a texture or a constant.
#pragma once

#include <cstdint>

#include "core/spectrum.h"

namespace umbral {

inline constexpr std::uint32_t no_index = 0xffffffffu;

enum class TextureId : std::uint32_t { none = no_index };
enum class MaterialId : std::uint32_t { none = no_index };
enum class LightId : std::uint32_t { none = no_index };
enum class ObjectId : std::uint32_t { none = no_index };

template <class Id>
constexpr std::uint32_t index_of(Id id) {
  return static_cast<std::uint32_t>(id);
}

// A constant, or a texture in its place: a constant costs one predictable branch.
template <class T>
struct Textured {
  T value;
  TextureId map = TextureId::none;

  bool is_constant() const { return map == TextureId::none; }
  // Whether they are the same everywhere; a value that a texture replaces does not count.
  bool operator==(const Textured& other) const {
    return map == other.map && (!is_constant() || value == other.value);
  }
};

}  // namespace umbral
