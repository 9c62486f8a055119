// Reading of accessors.
#include "formats/gltf/accessors.h"

#include <algorithm>
#include <cstring>

namespace umbral::gltf {
namespace {

// As glTF maps integers to numbers [Khronos 2021, 3.6.2.2 and 3.11].
template <class T>
float normalized(T value) {
  constexpr auto largest = static_cast<float>(std::numeric_limits<T>::max());
  return std::max(static_cast<float>(value) / largest, -1.0f);
}

// Where elements of a view begin, and how far apart they are.
struct Elements {
  const char* first;
  std::size_t stride;
};

Elements elements_of(const Document& document, Ref<List::buffer_views> ref, Whole offset, std::size_t bytes) {
  const BufferView& view = document[ref];
  return {document.bytes[view.buffer.index].bytes.data() + view.byte_offset + offset,
          view.byte_stride > 0 ? view.byte_stride : bytes};
}

template <class T>
T load(const char* bytes) {
  T value;
  std::memcpy(&value, bytes, sizeof(T));
  return value;
}

// Copies `count` elements of type From to `out`, the i-th at place(i) elements.
template <class From, class To, class Place>
void copy_elements(const Elements& from, const Layout& layout, std::size_t count, bool normalize, Place place,
                   To* out) {
  const std::size_t components = layout.components();
  for (std::size_t i = 0; i < count; ++i) {
    const char* element = from.first + i * from.stride;
    To* to = out + place(i) * components;
    for (std::size_t c = 0; c < layout.columns; ++c)
      for (std::size_t r = 0; r < layout.rows; ++r) {
        const From value = load<From>(element + c * layout.column_bytes + r * sizeof(From));
        if constexpr (std::is_same_v<To, float> && !std::is_same_v<From, float>)
          *to++ = normalize ? normalized(value) : static_cast<float>(value);
        else
          *to++ = static_cast<To>(value);
      }
  }
}

template <class To, class Place>
void copy_any(const Elements& from, const Accessor& accessor, std::size_t count, Place place, To* out) {
  const Layout layout = layout_of(accessor);
  const bool normalize = accessor.normalized;
  switch (accessor.component_type) {
    case int8:
      return copy_elements<std::int8_t>(from, layout, count, normalize, place, out);
    case uint8:
      return copy_elements<std::uint8_t>(from, layout, count, normalize, place, out);
    case int16:
      return copy_elements<std::int16_t>(from, layout, count, normalize, place, out);
    case uint16:
      return copy_elements<std::uint16_t>(from, layout, count, normalize, place, out);
    case uint32:
      return copy_elements<std::uint32_t>(from, layout, count, normalize, place, out);
    default:
      if constexpr (std::is_same_v<To, float>)
        copy_elements<float>(from, layout, count, normalize, place, out);
  }
}

template <class T>
void copy_base(const Document& document, const Accessor& accessor, T* out) {
  if (!accessor.view) return;
  const Layout layout = layout_of(accessor);
  const Elements from = elements_of(document, accessor.view, accessor.byte_offset, layout.element_bytes());
  const std::size_t packed = layout.components() * sizeof(T);
  if (accessor.component_type == float32 && from.stride == packed && std::is_same_v<T, float>)
    std::memcpy(out, from.first, accessor.count * packed);
  else
    copy_any(
        from, accessor, accessor.count, [](std::size_t i) { return i; }, out);
}

template <class T>
void copy_sparse(const Document& document, const Accessor& accessor, T* out) {
  if (!accessor.sparse) return;
  const Sparse& sparse = *accessor.sparse;
  Accessor index_accessor;
  index_accessor.component_type = sparse.indices.component_type;
  index_accessor.type = "SCALAR";
  std::vector<std::uint32_t> indices(sparse.count);
  const std::size_t bytes = component_bytes(sparse.indices.component_type);
  copy_any(
      elements_of(document, sparse.indices.view, sparse.indices.byte_offset, bytes), index_accessor,
      sparse.count, [](std::size_t i) { return i; }, indices.data());
  for (std::uint32_t& index : indices)  // what is out of range was told by the checks
    index = std::min(index, static_cast<std::uint32_t>(accessor.count - 1));
  const Layout layout = layout_of(accessor);
  copy_any(
      elements_of(document, sparse.values.view, sparse.values.byte_offset, layout.element_bytes()), accessor,
      sparse.count, [&](std::size_t i) { return indices[i]; }, out);
}

}  // namespace

std::size_t component_bytes(Whole component_type) {
  switch (component_type) {
    case int8:
    case uint8:
      return 1;
    case int16:
    case uint16:
      return 2;
    case uint32:
    case float32:
      return 4;
    default:
      return 0;
  }
}

Layout layout_of(const Accessor& accessor) {
  struct Shape {
    const char* type;
    std::size_t rows, columns;
  };
  static constexpr std::array shapes{Shape{"SCALAR", 1, 1}, Shape{"VEC2", 2, 1}, Shape{"VEC3", 3, 1},
                                     Shape{"VEC4", 4, 1},   Shape{"MAT2", 2, 2}, Shape{"MAT3", 3, 3},
                                     Shape{"MAT4", 4, 4}};
  Layout layout;
  layout.component_bytes = component_bytes(accessor.component_type);
  for (const Shape& shape : shapes)
    if (accessor.type == shape.type) {
      layout.rows = shape.rows;
      layout.columns = shape.columns;
    }
  const std::size_t bytes = layout.rows * layout.component_bytes;
  layout.column_bytes = layout.columns > 1 ? (bytes + 3) / 4 * 4 : bytes;
  return layout;
}

bool has_data(const Document& document, const Accessor& accessor) {
  const auto there = [&](Ref<List::buffer_views> view) {
    return !view || document.bytes[document[view].buffer.index].owner != nullptr;
  };
  if (accessor.sparse && !(there(accessor.sparse->indices.view) && there(accessor.sparse->values.view)))
    return false;
  return there(accessor.view);
}

std::vector<float> read_floats(const Document& document, const Accessor& accessor) {
  std::vector<float> values(accessor.count * layout_of(accessor).components());
  copy_base(document, accessor, values.data());
  copy_sparse(document, accessor, values.data());
  return values;
}

template <class T>
std::vector<T> read_vectors(const Document& document, const Accessor& accessor) {
  std::vector<T> values(accessor.count, T(0));
  static_assert(sizeof(T) == T::length() * sizeof(float));
  copy_base(document, accessor, &values[0][0]);
  copy_sparse(document, accessor, &values[0][0]);
  return values;
}
template std::vector<glm::vec2> read_vectors(const Document&, const Accessor&);
template std::vector<glm::vec3> read_vectors(const Document&, const Accessor&);
template std::vector<glm::vec4> read_vectors(const Document&, const Accessor&);

std::vector<std::uint32_t> read_whole(const Document& document, const Accessor& accessor) {
  std::vector<std::uint32_t> values(accessor.count * layout_of(accessor).components());
  copy_base(document, accessor, values.data());
  copy_sparse(document, accessor, values.data());
  return values;
}

}  // namespace umbral::gltf
