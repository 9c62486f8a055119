// The text of an OBJ file as lists of numbers.
//
// An own reader, as libtinyobjloader tells no line or column and drops broken faces without a word.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "core/math.h"
#include "formats/input/text_cursor.h"

namespace umbral {

// Indices from 0; −1 for what a corner does not have.
struct ObjCorner {
  std::int32_t position, uv, normal;
};

struct ObjFace {
  std::uint32_t end;       // in ObjFile::corners; it begins where the face before it ends
  std::uint32_t material;  // in ObjFile::materials
  std::int32_t line;
};

// A name in the file and where it stands first.
struct ObjName {
  std::string name;
  Place place;
};

struct ObjFile {
  std::vector<Vec3> positions;  // finite
  std::vector<Vec2> uvs;
  std::vector<Vec3> normals;  // as they stand
  std::vector<ObjCorner> corners;
  std::vector<ObjFace> faces;  // of three corners or more
  std::vector<ObjName>
      materials;  // that faces ask for; the first, without name, is that of faces before any 'usemtl'
  std::vector<ObjName> libraries;  // each the whole of what follows a 'mtllib'

  std::span<const ObjCorner> corners_of(std::size_t face) const {
    const std::uint32_t begin = face == 0 ? 0 : faces[face - 1].end;
    return {corners.data() + begin, faces[face].end - begin};
  }
};

// Reads v, vt, vn, f, usemtl and mtllib; tells what else there was in a warning. All indices of the result
// are valid unless `errors` has any.
ObjFile parse_obj(std::string_view text, TextErrors& errors);

}  // namespace umbral
