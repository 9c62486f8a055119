// How the objects of a glTF file are described: each property's name, member and range, from which JSON is read.
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <tuple>
#include <vector>

#include "core/parameters.h"
#include "scene/ids.h"

namespace umbral::gltf {

// A described struct T has
//   static constexpr auto properties = std::tuple{property<&T::count>("count", positive), …};
// and, where extensions may stand in it,
//   static constexpr auto extensions = std::tuple{property<&T::volume>("KHR_materials_volume"), …};
// The type of a member says what JSON it takes: numbers, text, lists (std::vector, std::array for a known length),
// objects (described structs), maps, std::optional for objects that may be absent, and references (Ref).
template <auto Member>
struct Property {
  static constexpr auto member = Member;
  const char* name;
  Range range;
  bool required;
};

template <auto Member>
constexpr Property<Member> property(const char* name, Range range = any_number) {
  return {name, range, false};
}

template <auto Member>
constexpr Property<Member> required(const char* name, Range range = any_number) {
  return {name, range, true};
}

// The lists of a document that others refer to by index.
enum class List {
  accessors,
  buffers,
  buffer_views,
  cameras,
  images,
  materials,
  meshes,
  nodes,
  samplers,
  scenes,
  skins,
  textures,
  lights,
  variants
};
inline constexpr std::array list_pointers{"/accessors",
                                          "/buffers",
                                          "/bufferViews",
                                          "/cameras",
                                          "/images",
                                          "/materials",
                                          "/meshes",
                                          "/nodes",
                                          "/samplers",
                                          "/scenes",
                                          "/skins",
                                          "/textures",
                                          "/extensions/KHR_lights_punctual/lights",
                                          "/extensions/KHR_materials_variants/variants"};

// An index into a list of the document; it is valid once the file is read without errors.
template <List list>
struct Ref {
  std::uint32_t index = no_index;

  explicit operator bool() const { return index != no_index; }
  bool operator==(const Ref&) const = default;
};

using Whole = std::uint64_t;  // a count or an offset

inline constexpr Range whole_positive{1, 0x1p53f};
inline constexpr Range whole{0, 0x1p53f};

}  // namespace umbral::gltf
