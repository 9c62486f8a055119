// The header of a PLY file.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "formats/input/text_cursor.h"

namespace umbral {

enum class PlyFormat { ascii, binary_little_endian, binary_big_endian };
enum class PlyType { int8, uint8, int16, uint16, int32, uint32, float32, float64 };

std::size_t size_of(PlyType type);  // bytes

struct PlyProperty {
  std::string name;
  PlyType type;
  bool is_list = false;
  PlyType count_type = PlyType::uint8;  // of a list
};

struct PlyElement {
  std::string name;
  std::uint64_t count;
  std::vector<PlyProperty> properties;

  // None if there is no such property.
  std::optional<std::size_t> find(std::string_view property) const;
};

struct PlyHeader {
  PlyFormat format = PlyFormat::ascii;
  std::vector<PlyElement> elements;
};

// Reads up to the start of the body, where it leaves the cursor. Throws SceneError, also where the rest of
// the file is too small to hold as many elements as the header says.
PlyHeader parse_ply_header(TextCursor& in, const std::shared_ptr<const SourceText>& source);

// A SceneError at that place, with the excerpt.
[[noreturn]] void throw_at(const std::shared_ptr<const SourceText>& source, int line, int column,
                           std::string message);

}  // namespace umbral
