// Vertices and faces from the body of a PLY file.
#include "formats/ply/ply_reader.h"

#include <array>

#include <fmt/format.h>

#include "formats/meshes/triangulate.h"
#include "formats/ply/ply_values.h"

namespace umbral {
namespace {

// Where a value of a vertex goes: 0 … 2 position, 3 … 5 normal, 6 and 7 uv, 8 … 11 colour and alpha, 12 and 13 a
// second uv.
constexpr std::size_t slots = 14, no_slot = slots;

std::size_t slot_of(const std::string& property) {
  static constexpr std::array<const char*, slots> names{"x", "y",   "z",     "nx",   "ny",    "nz", "u",
                                                        "v", "red", "green", "blue", "alpha", "u1", "v1"};
  static constexpr std::array<std::array<const char*, 2>, 3> other_uvs{
      {{"s", "t"}, {"texture_u", "texture_v"}, {"texture_s", "texture_t"}}};
  static constexpr std::array<std::array<const char*, 3>, 2> other_colors{
      {{"r", "g", "b"}, {"color_0", "color_1", "color_2"}}};
  for (std::size_t i = 0; i < slots; ++i)
    if (property == names[i]) return i;
  for (const auto& color : other_colors)
    for (std::size_t i = 0; i < 3; ++i)
      if (property == color[i]) return 8 + i;
  for (const auto& uv : other_uvs)
    for (std::size_t i = 0; i < 2; ++i)
      if (property == uv[i]) return 6 + i;
  return no_slot;
}

// Where the values of an element's properties go.
class Layout {
 public:
  std::vector<std::size_t> targets;  // a slot for each property
  std::array<bool, slots> has{};

  // `attribute`: what takes the place of the colours; empty for none.
  Layout(const PlyElement& element, const std::string& attribute) : is_attribute_(!attribute.empty()) {
    std::size_t next = 8;
    for (const PlyProperty& property : element.properties) {
      std::size_t slot = property.is_list ? no_slot : slot_of(property.name);
      if (is_attribute_ && slot >= 8 && slot <= 11) slot = no_slot;
      if (!property.is_list && next <= 11 && is_part(property.name, attribute)) slot = next++;
      targets.push_back(slot);
      if (slot != no_slot) has[slot] = true;
      if (slot == 8) type_ = property.type;
    }
  }
  bool has_colors() const { return has[8] && (is_attribute_ || (has[9] && has[10])); }

  // Colours as whole numbers are sRGB codes, as scanners and modellers write them; others are linear.
  Spectrum color(const std::array<float, slots>& v) const {
    const float most = type_ == PlyType::uint8 ? 255 : type_ == PlyType::uint16 ? 65535 : 1;
    Spectrum color(v[8], v[9], v[10], has[11] ? v[11] : most);
    if (!has[9]) color.g = color.b = color.r;
    if (type_ == PlyType::float32 || type_ == PlyType::float64) return color;
    color /= most;
    if (is_attribute_) return color;
    return {srgb_decode(color.r), srgb_decode(color.g), srgb_decode(color.b), color.a};
  }

 private:
  static bool is_part(const std::string& property, const std::string& attribute) {
    return !attribute.empty() && property.size() == attribute.size() + 2 && property.starts_with(attribute) &&
           property[attribute.size()] == '_';
  }

  bool is_attribute_;
  PlyType type_ = PlyType::float32;
};

// Gives each triangle its own vertices, of its colour.
void split_triangles(Mesh& mesh, const std::vector<Spectrum>& colors) {
  Mesh split;
  const auto copy = [](const auto& from, auto& to, std::uint32_t vertex) {
    if (!from.empty()) to.push_back(from[vertex]);
  };
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    const auto first = static_cast<std::uint32_t>(split.positions.size());
    for (int k = 0; k < 3; ++k) {
      const std::uint32_t vertex = mesh.triangles[i][k];
      split.positions.push_back(mesh.positions[vertex]);
      copy(mesh.normals, split.normals, vertex);
      copy(mesh.uvs, split.uvs, vertex);
      copy(mesh.uvs1, split.uvs1, vertex);
      split.colors.push_back(colors[i]);
    }
    split.triangles.push_back({first, first + 1, first + 2});
  }
  mesh = std::move(split);
}

template <class Values>
class BodyReader {
 public:
  BodyReader(Values values, PlyColors colors) : values_(std::move(values)), colors_(std::move(colors)) {}

  Mesh read(const PlyHeader& header, std::vector<std::string>& warnings);

 private:
  double value(PlyType type, const PlyElement& element, std::uint64_t index);
  std::uint64_t list_length(const PlyProperty& list, const PlyElement& element, std::uint64_t index);
  void skip_property(const PlyProperty& property, const PlyElement& element, std::uint64_t index);
  void read_vertices(const PlyElement& element);
  void read_faces(const PlyElement& element);
  void read_polygon(const PlyProperty& list, const PlyElement& element, std::uint64_t face);

  Values values_;
  PlyColors colors_;
  Mesh mesh_;
  std::vector<Spectrum> triangle_colors_;  // where they are those of faces
  std::vector<std::uint32_t> polygon_;
  std::size_t small_faces_ = 0;
};

template <class Values>
double BodyReader<Values>::value(PlyType type, const PlyElement& element, std::uint64_t index) {
  double number = 0;
  if (!values_.next(type, number))
    values_.fail(
        fmt::format("the file ends or is broken in '{}' {} of {}", element.name, index + 1, element.count));
  return number;
}

template <class Values>
std::uint64_t BodyReader<Values>::list_length(const PlyProperty& list, const PlyElement& element,
                                              std::uint64_t index) {
  const double length = value(list.count_type, element, index);
  if (!(length >= 0 && length < 4294967296.0 && length == std::floor(length)))
    values_.fail(fmt::format("a list in '{}' {} cannot have {} entries", element.name, index + 1, length));
  return static_cast<std::uint64_t>(length);
}

template <class Values>
void BodyReader<Values>::skip_property(const PlyProperty& property, const PlyElement& element,
                                       std::uint64_t index) {
  const std::uint64_t count = property.is_list ? list_length(property, element, index) : 1;
  for (std::uint64_t i = 0; i < count; ++i) value(property.type, element, index);
}

template <class Values>
void BodyReader<Values>::read_vertices(const PlyElement& element) {
  const Layout layout(element, colors_.attribute);
  const auto& targets = layout.targets;
  const auto& has = layout.has;
  if (!has[0] || !has[1] || !has[2]) values_.fail("the vertices have no x, y and z");
  const bool normals = has[3] && has[4] && has[5], uvs = has[6] && has[7], uvs1 = has[12] && has[13];
  const bool colors = !colors_.of_faces && layout.has_colors();
  mesh_.positions.reserve(element.count);
  if (normals) mesh_.normals.reserve(element.count);
  if (uvs) mesh_.uvs.reserve(element.count);
  std::array<float, slots> v{};
  for (std::uint64_t i = 0; i < element.count; ++i) {
    for (std::size_t k = 0; k < targets.size(); ++k) {
      if (targets[k] == no_slot)
        skip_property(element.properties[k], element, i);
      else
        v[targets[k]] = static_cast<float>(value(element.properties[k].type, element, i));
    }
    mesh_.positions.push_back({v[0], v[1], v[2]});
    if (!is_finite(mesh_.positions.back())) values_.fail(fmt::format("vertex {} is not finite", i));
    if (normals) mesh_.normals.push_back({v[3], v[4], v[5]});
    if (uvs) mesh_.uvs.push_back({v[6], v[7]});
    if (uvs1) mesh_.uvs1.push_back({v[12], v[13]});
    if (colors) mesh_.colors.push_back(layout.color(v));
  }
}

template <class Values>
void BodyReader<Values>::read_polygon(const PlyProperty& list, const PlyElement& element,
                                      std::uint64_t face) {
  polygon_.clear();
  const std::uint64_t corners = list_length(list, element, face);
  for (std::uint64_t i = 0; i < corners; ++i) {
    const double index = value(list.type, element, face);
    if (!(index >= 0 && index < static_cast<double>(mesh_.positions.size())) || index != std::floor(index))
      values_.fail(fmt::format("face {} names vertex {}, but there are {} vertices, numbered from 0", face,
                               index, mesh_.positions.size()));
    polygon_.push_back(static_cast<std::uint32_t>(index));
  }
  if (corners < 3)
    ++small_faces_;
  else if (!triangulate(polygon_, mesh_.positions, mesh_.triangles))
    values_.fail(
        fmt::format("face {} is concave and has more than {} corners", face, largest_concave_polygon));
}

template <class Values>
void BodyReader<Values>::read_faces(const PlyElement& element) {
  std::optional<std::size_t> indices = element.find("vertex_indices");
  if (!indices) indices = element.find("vertex_index");
  if (!indices || !element.properties[*indices].is_list)
    values_.fail("the faces have no list 'vertex_indices'");
  const Layout layout(element, colors_.attribute);
  const bool colors = colors_.of_faces && layout.has_colors();
  mesh_.triangles.reserve(element.count);
  std::array<float, slots> v{};
  for (std::uint64_t face = 0; face < element.count; ++face) {
    for (std::size_t k = 0; k < element.properties.size(); ++k) {
      if (k == *indices)
        read_polygon(element.properties[k], element, face);
      else if (colors && layout.targets[k] != no_slot)
        v[layout.targets[k]] = static_cast<float>(value(element.properties[k].type, element, face));
      else
        skip_property(element.properties[k], element, face);
    }
    if (colors) triangle_colors_.resize(mesh_.triangles.size(), layout.color(v));
  }
}

template <class Values>
Mesh BodyReader<Values>::read(const PlyHeader& header, std::vector<std::string>& warnings) {
  bool has_faces = false;
  for (const PlyElement& element : header.elements) {
    if (element.properties.empty()) continue;
    if (element.name == "vertex") {
      read_vertices(element);
    } else if (element.name == "face") {
      read_faces(element);
      has_faces = true;
    } else {
      warnings.push_back(fmt::format("not used: {} elements '{}'", element.count, element.name));
      for (std::uint64_t i = 0; i < element.count; ++i)
        for (const PlyProperty& property : element.properties) skip_property(property, element, i);
    }
  }
  if (!has_faces) values_.fail("the file has no faces");
  if (small_faces_ > 0)
    warnings.push_back(fmt::format("not used: {} faces of fewer than 3 corners", small_faces_));
  if (!triangle_colors_.empty()) split_triangles(mesh_, triangle_colors_);
  return std::move(mesh_);
}

}  // namespace

Mesh read_ply(const std::shared_ptr<const SourceText>& source, std::vector<std::string>& warnings,
              const PlyColors& colors) {
  TextCursor in(source->text());
  const PlyHeader header = parse_ply_header(in, source);
  switch (header.format) {
    case PlyFormat::ascii:
      return BodyReader(AsciiPlyValues(in, source), colors).read(header, warnings);
    case PlyFormat::binary_little_endian:
      return BodyReader(BinaryPlyValues<std::endian::little>(in, source), colors).read(header, warnings);
    case PlyFormat::binary_big_endian:
      return BodyReader(BinaryPlyValues<std::endian::big>(in, source), colors).read(header, warnings);
  }
  return {};
}

}  // namespace umbral
