// The numbers behind accessors: of any component type, interleaved, normalised, sparse.
#pragma once

#include <vector>

#include <glm/glm.hpp>

#include "formats/gltf/document.h"

namespace umbral::gltf {

enum ComponentType : Whole {
  int8 = 5120,
  uint8 = 5121,
  int16 = 5122,
  uint16 = 5123,
  uint32 = 5125,
  float32 = 5126
};

// How the elements of an accessor lie; all 0 where its type is unknown.
struct Layout {
  std::size_t component_bytes = 0;
  std::size_t rows = 0, columns = 0;  // of a matrix; a vector is one column
  std::size_t column_bytes = 0;       // columns of matrices begin at multiples of 4
  std::size_t components() const { return rows * columns; }
  std::size_t element_bytes() const { return columns * column_bytes; }
  std::size_t last_element_bytes() const { return element_bytes() - column_bytes + rows * component_bytes; }
  explicit operator bool() const { return rows > 0 && component_bytes > 0; }
};
Layout layout_of(const Accessor& accessor);
std::size_t component_bytes(Whole component_type);

// Whether its bytes are there; an accessor without a view is all zeros.
bool has_data(const Document& document, const Accessor& accessor);

// All elements, one component after the other (matrices by columns), as floats; integers that the accessor calls
// normalised lie in [−1, 1] or [0, 1]. The document must have been checked, and has_data().
std::vector<float> read_floats(const Document& document, const Accessor& accessor);

// As vectors with `n` = T::length() components, as many as the accessor has.
template <class T>
std::vector<T> read_vectors(const Document& document, const Accessor& accessor);
extern template std::vector<glm::vec2> read_vectors(const Document&, const Accessor&);
extern template std::vector<glm::vec3> read_vectors(const Document&, const Accessor&);
extern template std::vector<glm::vec4> read_vectors(const Document&, const Accessor&);

// Of whole numbers.
std::vector<std::uint32_t> read_whole(const Document& document, const Accessor& accessor);

}  // namespace umbral::gltf
