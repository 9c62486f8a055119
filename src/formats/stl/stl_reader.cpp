// Facets of STL files.
#include "formats/stl/stl_reader.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cstring>

#include <fmt/format.h>

#include "formats/input/text_cursor.h"

namespace umbral {
namespace {

constexpr std::size_t header_bytes = 84, facet_bytes = 50;

std::size_t facet_count(std::string_view bytes) {
  std::uint32_t count = 0;
  std::memcpy(&count, bytes.data() + 80, sizeof(count));
  return count;
}

// Binary files may begin with "solid" too: then their length tells.
bool is_binary(std::string_view bytes) {
  if (bytes.size() >= header_bytes && bytes.size() == header_bytes + facet_bytes * facet_count(bytes))
    return true;
  const std::size_t first = bytes.find_first_not_of(" \t\r\n");
  return first == std::string_view::npos || !bytes.substr(first).starts_with("solid");
}

void add_triangle(Mesh& mesh) {
  const auto first = static_cast<std::uint32_t>(mesh.positions.size() - 3);
  mesh.triangles.push_back({first, first + 1, first + 2});
}

Mesh read_binary(std::string_view bytes, const std::string& name, std::vector<std::string>& warnings) {
  if (bytes.size() < header_bytes)
    throw SceneError({name}, fmt::format("a binary STL file begins with {} bytes, but it has {}",
                                         header_bytes, bytes.size()));
  const std::size_t count = facet_count(bytes), there = (bytes.size() - header_bytes) / facet_bytes;
  if (there < count)
    throw SceneError({name}, fmt::format("the file is cut: it has {} facets of {}", there, count));
  if (bytes.size() > header_bytes + count * facet_bytes)
    warnings.push_back(fmt::format("{} bytes behind its {} facets are not used",
                                   bytes.size() - header_bytes - count * facet_bytes, count));
  Mesh mesh;
  mesh.positions.reserve(3 * count);
  mesh.triangles.reserve(count);
  for (std::size_t i = 0; i < count; ++i) {
    const char* corners = bytes.data() + header_bytes + i * facet_bytes + 12;  // after the normal
    for (std::size_t k = 0; k < 3; ++k) {
      std::array<float, 3> p;
      std::memcpy(p.data(), corners + 12 * k, sizeof(p));
      mesh.positions.push_back({p[0], p[1], p[2]});
    }
    add_triangle(mesh);
  }
  return mesh;
}

// Words in any case, as programs write them.
class AsciiReader {
 public:
  explicit AsciiReader(const std::shared_ptr<const SourceText>& source)
      : source_(source), in_(source->text()) {}

  Mesh read() {
    bool begun = false;
    while (next()) {
      if (is("solid"))
        begun = true;
      else if (is("vertex") && begun)
        read_vertex();
      else if (is("endfacet"))
        end_facet();
      else if (!is("facet") && !is("outer") && !is("endloop") && !is("endsolid"))
        fail(fmt::format("'{}' is no word of an STL file", word_.substr(0, 40)));
      in_.next_line();
    }
    if (corners_ > 0) fail("the file ends within a facet");
    return std::move(mesh_);
  }

 private:
  // The first word of the next line that has any.
  bool next() {
    while (!in_.at_end() && in_.at_line_end()) in_.next_line();
    if (in_.at_end()) return false;
    line_ = in_.line();
    column_ = in_.column(in_.position());
    word_ = std::string(in_.word());
    std::transform(word_.begin(), word_.end(), word_.begin(),
                   [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    return true;
  }
  bool is(const char* word) const { return word_ == word; }

  [[noreturn]] void fail(const std::string& message) const {
    throw SceneError(
        {{Severity::error, {source_->name(), line_, column_}, message, source_->excerpt(line_, column_)}});
  }

  void read_vertex() {
    Vec3d p(0);
    for (int k = 0; k < 3; ++k)
      if (!in_.number(p[k])) fail("a vertex needs three numbers");
    if (++corners_ > 3) fail("a facet of STL has three corners");
    mesh_.positions.push_back(Vec3(p));
  }

  void end_facet() {
    if (corners_ != 3) fail(fmt::format("a facet of STL has three corners, but this one {}", corners_));
    add_triangle(mesh_);
    corners_ = 0;
  }

  std::shared_ptr<const SourceText> source_;
  TextCursor in_;
  std::string word_;
  int line_ = 0, column_ = 0, corners_ = 0;
  Mesh mesh_;
};

}  // namespace

Mesh read_stl(const std::shared_ptr<const SourceText>& source, std::vector<std::string>& warnings) {
  Mesh mesh = is_binary(source->text()) ? read_binary(source->text(), source->name(), warnings)
                                        : AsciiReader(source).read();
  const auto bad = std::count_if(mesh.positions.begin(), mesh.positions.end(),
                                 [](const Vec3& p) { return !is_finite(p); });
  if (bad > 0)
    throw SceneError({source->name()}, fmt::format("{} of its {} corners are infinite or not numbers", bad,
                                                   mesh.positions.size()));
  return mesh;
}

}  // namespace umbral
