// Checks of buffer views and accessors, and of the numbers that they hold.
#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "formats/gltf/accessors.h"
#include "formats/gltf/checks.h"

namespace umbral::gltf {
namespace {

constexpr Whole index_target = 34963;
constexpr std::size_t most_zeros = std::size_t{1} << 26;  // bytes that an accessor without data may stand for

void check_view(const Document& document, const BufferView& view, const std::string& path, Report& report) {
  const Whole length = document.buffers[view.buffer.index].byte_length;
  if (view.byte_offset > length || view.byte_length > length - view.byte_offset)
    report.error(path, fmt::format("bytes {} to {} are not within the buffer's {}", view.byte_offset,
                                   view.byte_offset + view.byte_length, length));
  if (view.byte_stride == 0) return;
  if (view.byte_stride % 4 != 0)
    report.error(path + "/byteStride", fmt::format("{} is no multiple of 4", view.byte_stride));
  if (view.byte_stride > view.byte_length)
    report.error(path + "/byteStride", fmt::format("{} is more than its byteLength", view.byte_stride));
  if (view.target == index_target) report.error(path + "/byteStride", "it has no meaning for indices");
}

// Whether `count` elements from `offset` on lie within the view; the last may lack its padding.
bool fits(const BufferView& view, Whole offset, Whole count, std::size_t bytes, std::size_t last_bytes) {
  const Whole stride = view.byte_stride > 0 ? view.byte_stride : bytes;
  if (offset > view.byte_length || last_bytes > view.byte_length - offset) return false;
  return count - 1 <= (view.byte_length - offset - last_bytes) / stride;
}

void check_base(const Document& document, const Accessor& accessor, const std::string& path, Report& report) {
  const Layout layout = layout_of(accessor);
  const BufferView& view = document[accessor.view];
  if (view.byte_stride > 0 && view.byte_stride < layout.element_bytes())
    report.error(path, fmt::format("its elements have {} bytes, but the view's byteStride is {}",
                                   layout.element_bytes(), view.byte_stride));
  if (!fits(view, accessor.byte_offset, accessor.count, layout.element_bytes(), layout.last_element_bytes()))
    report.error(path,
                 fmt::format("its {} elements of {} bytes are not within bufferView {} of {} bytes",
                             accessor.count, layout.element_bytes(), accessor.view.index, view.byte_length));
  if ((accessor.byte_offset + view.byte_offset) % layout.component_bytes != 0)
    report.warning(path, "its offset is no multiple of its component's size");
}

void check_sparse(const Document& document, const Accessor& accessor, const std::string& path,
                  Report& report) {
  const Sparse& sparse = *accessor.sparse;
  const Layout layout = layout_of(accessor);
  const BufferView &indices = document[sparse.indices.view], &values = document[sparse.values.view];
  const std::size_t index_bytes = component_bytes(sparse.indices.component_type);
  if (sparse.count > accessor.count)
    return report.error(path + "/sparse/count", fmt::format("{} is more than the accessor's count, {}",
                                                            sparse.count, accessor.count));
  if (indices.byte_stride > 0 || values.byte_stride > 0)
    return report.error(path + "/sparse", "its buffer views must have no byteStride");
  const Whole type = sparse.indices.component_type;
  if (type != uint8 && type != uint16 && type != uint32)
    return report.error(path + "/sparse/indices/componentType", fmt::format("{} is none of an index", type));
  if (!fits(indices, sparse.indices.byte_offset, sparse.count, index_bytes, index_bytes) ||
      !fits(values, sparse.values.byte_offset, sparse.count, layout.element_bytes(),
            layout.last_element_bytes()))
    report.error(path + "/sparse", "it is not within its buffer views");
}

void check_accessor(const Document& document, const Accessor& accessor, const std::string& path,
                    Report& report) {
  if (accessor.byte_offset > 0 && !accessor.view)
    report.error(path, "it has a 'byteOffset', but no 'bufferView'");
  if (accessor.normalized && (accessor.component_type == float32 || accessor.component_type == uint32))
    report.error(path + "/normalized", "only integers of 8 and 16 bits can be normalised");
  const Layout layout = layout_of(accessor);
  if (!layout)
    return report.warning(path, fmt::format("its type, {} of component type {}, is unknown", accessor.type,
                                            accessor.component_type));
  if (accessor.view)
    check_base(document, accessor, path, report);
  else if (accessor.count > most_zeros / layout.element_bytes())
    report.error(path, fmt::format("it has {} elements, but no data", accessor.count));
  if (accessor.sparse) check_sparse(document, accessor, path, report);
  for (const auto* bounds : {&accessor.min, &accessor.max})
    if (!bounds->empty() && bounds->size() != layout.components())
      report.error(path, fmt::format("its 'min' and 'max' must have {} values", layout.components()));
}

// The numbers themselves.
void check_values(const Document& document, const Accessor& accessor, const std::string& path,
                  Report& report) {
  const Layout layout = layout_of(accessor);
  const bool bounded = !accessor.min.empty() || !accessor.max.empty();
  if (!layout || !has_data(document, accessor) || (accessor.component_type != float32 && !bounded)) return;
  Accessor raw = accessor;
  raw.normalized = false;
  const std::vector<float> values = read_floats(document, raw);
  const std::size_t n = layout.components();
  std::vector<float> low(n, infinity), high(n, -infinity);
  float sum = 0;  // not a number as soon as a value is none
  for (std::size_t i = 0; i < values.size(); i += n)
    for (std::size_t k = 0; k < n; ++k) {
      sum += values[i + k] * 0;
      low[k] = std::min(low[k], values[i + k]);
      high[k] = std::max(high[k], values[i + k]);
    }
  if (sum != 0) return report.error(path, "it holds values that are infinite or not numbers");
  const auto differs = [&](const std::vector<double>& told, const std::vector<float>& found) {
    for (std::size_t k = 0; k < told.size(); ++k)
      if (static_cast<float>(told[k]) != found[k]) return true;
    return false;
  };
  if (differs(accessor.min, low) || differs(accessor.max, high))
    report.warning(path, "its 'min' and 'max' are not those of its values; the values hold");
}

void check_sparse_indices(const Document& document, const Accessor& accessor, const std::string& path,
                          Report& report) {
  if (!accessor.sparse || !has_data(document, accessor)) return;
  Accessor indices;
  indices.view = accessor.sparse->indices.view;
  indices.byte_offset = accessor.sparse->indices.byte_offset;
  indices.component_type = accessor.sparse->indices.component_type;
  indices.count = accessor.sparse->count;
  indices.type = "SCALAR";
  const std::vector<std::uint32_t> values = read_whole(document, indices);
  if (*std::max_element(values.begin(), values.end()) >= accessor.count)
    report.error(path + "/sparse/indices", "an index is beyond the accessor's count");
  if (!std::is_sorted(values.begin(), values.end(), std::less_equal<>()))
    report.error(path + "/sparse/indices", "its indices do not increase");
}

}  // namespace

void check_data(const Document& document, Report& report) {
  const std::size_t errors = report.errors();
  for (std::size_t i = 0; i < document.buffer_views.size(); ++i)
    check_view(document, document.buffer_views[i], fmt::format("/bufferViews/{}", i), report);
  for (std::size_t i = 0; i < document.accessors.size(); ++i)
    check_accessor(document, document.accessors[i], fmt::format("/accessors/{}", i), report);
  if (report.errors() > errors) return;  // a view may reach beyond its buffer: nothing may be read through it
  for (std::size_t i = 0; i < document.accessors.size(); ++i) {
    check_values(document, document.accessors[i], fmt::format("/accessors/{}", i), report);
    check_sparse_indices(document, document.accessors[i], fmt::format("/accessors/{}", i), report);
  }
}

}  // namespace umbral::gltf
