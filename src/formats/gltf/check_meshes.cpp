// Checks of primitives: their attributes, indices and morph targets.
#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "formats/gltf/accessors.h"
#include "formats/gltf/checks.h"

namespace umbral::gltf {
namespace {

// What glTF allows an attribute to be [Khronos 2021, 3.7.2.1], with KHR_mesh_quantization.
struct Semantic {
  const char* name;  // up to the number
  bool numbered;
  std::vector<std::string> types;
  std::vector<Whole> components, quantized;
};

const std::vector<Semantic>& semantics() {
  static const std::vector<Semantic> table{
      {"POSITION", false, {"VEC3"}, {float32}, {int8, uint8, int16, uint16}},
      {"NORMAL", false, {"VEC3"}, {float32}, {int8, int16}},
      {"TANGENT", false, {"VEC4"}, {float32}, {int8, int16}},
      {"TEXCOORD", true, {"VEC2"}, {float32, uint8, uint16}, {int8, uint8, int16, uint16}},
      {"COLOR", true, {"VEC3", "VEC4"}, {float32, uint8, uint16}, {}},
      {"JOINTS", true, {"VEC4"}, {uint8, uint16}, {}},
      {"WEIGHTS", true, {"VEC4"}, {float32, uint8, uint16}, {}}};
  return table;
}

const Semantic* semantic_of(const std::string& name) {
  for (const Semantic& semantic : semantics()) {
    if (!semantic.numbered && name == semantic.name) return &semantic;
    const std::string prefix = std::string(semantic.name) + "_";
    const bool digits = name.size() > prefix.size() && name.size() < prefix.size() + 4 &&
                        std::all_of(name.begin() + static_cast<std::ptrdiff_t>(prefix.size()), name.end(),
                                    [](char c) { return c >= '0' && c <= '9'; });
    if (semantic.numbered && name.starts_with(prefix) && digits) return &semantic;
  }
  return nullptr;
}

template <class T>
bool among(const std::vector<T>& list, const T& value) {
  return std::find(list.begin(), list.end(), value) != list.end();
}

class PrimitiveChecks {
 public:
  PrimitiveChecks(const Document& document, const Primitive& primitive, std::string path, Report& report)
      : document_(document), primitive_(primitive), path_(std::move(path)), report_(report) {}

  void run();

 private:
  void check_attribute(const std::string& name, const Accessor& accessor, const std::string& path,
                       bool target);
  void check_vertices(const Attributes& attributes, const std::string& path);
  void check_numbering(const Attributes& attributes);
  void check_indices();
  void check_targets();

  const Document& document_;
  const Primitive& primitive_;
  std::string path_;
  Report& report_;
  Whole vertices_ = 0;
};

void PrimitiveChecks::check_attribute(const std::string& name, const Accessor& accessor,
                                      const std::string& path, bool target) {
  const Semantic* semantic = semantic_of(name);
  if (!semantic) {
    if (!name.starts_with('_')) report_.warning(path, "this attribute is unknown and not used");
    if (accessor.component_type == uint32) report_.error(path, "attributes cannot be of component type 5125");
    return;
  }
  std::vector<std::string> types = semantic->types;
  if (target && name == "TANGENT") types = {"VEC3"};
  const bool plain = among(semantic->components, accessor.component_type);
  const bool quantized = among(semantic->quantized, accessor.component_type);
  if (!among(types, accessor.type) || (!plain && !quantized))
    return report_.error(
        path, fmt::format("it cannot be {} of component type {}", accessor.type, accessor.component_type));
  if (quantized && !plain && !among(document_.extensions_required, std::string("KHR_mesh_quantization")))
    report_.warning(path, "its type needs KHR_mesh_quantization, which is not among /extensionsRequired");
}

void PrimitiveChecks::check_vertices(const Attributes& attributes, const std::string& path) {
  for (const auto& [name, ref] : attributes) {
    const Accessor& accessor = document_[ref];
    check_attribute(name, accessor, path + "/" + name, &attributes != &primitive_.attributes);
    if (accessor.count != vertices_)
      report_.error(path + "/" + name, fmt::format("it has {} vertices, but others of the primitive have {}",
                                                   accessor.count, vertices_));
    if (name == "POSITION" && (accessor.min.empty() || accessor.max.empty()))
      report_.warning(path + "/" + name, "its accessor lacks 'min' and 'max', which glTF demands");
    if (accessor.view && document_[accessor.view].target == 34963)
      report_.warning(path + "/" + name, "its buffer view says that it holds indices");
    const Layout layout = layout_of(accessor);
    if (accessor.view && layout && layout.element_bytes() % 4 != 0 &&
        document_[accessor.view].byte_stride == 0)
      report_.warning(path + "/" + name, "its elements do not begin at multiples of 4 bytes");
  }
}

// TEXCOORD_1 needs TEXCOORD_0.
void PrimitiveChecks::check_numbering(const Attributes& attributes) {
  for (const Semantic& semantic : semantics()) {
    if (!semantic.numbered) continue;
    std::size_t count = 0, highest = 0;
    for (const auto& [name, ref] : attributes)
      if (semantic_of(name) == &semantic) {
        ++count;
        highest = std::max<std::size_t>(highest, std::stoul(name.substr(name.find('_') + 1)) + 1);
      }
    if (highest > count)
      report_.warning(path_ + "/attributes", fmt::format("{}_0 to {}_{} are not all there", semantic.name,
                                                         semantic.name, highest - 1));
    if (std::string(semantic.name) == "JOINTS" && count != 0 && !attributes.contains("WEIGHTS_0"))
      report_.error(path_ + "/attributes", "it has JOINTS without WEIGHTS");
  }
  const auto count_of = [&](const char* prefix) {
    return std::count_if(attributes.begin(), attributes.end(),
                         [&](const auto& item) { return item.first.starts_with(prefix); });
  };
  if (count_of("JOINTS_") != count_of("WEIGHTS_"))
    report_.error(path_ + "/attributes", "it has not as many JOINTS as WEIGHTS");
}

void PrimitiveChecks::check_indices() {
  const Accessor& accessor = document_[primitive_.indices];
  const Whole type = accessor.component_type;
  const std::string path = path_ + "/indices";
  if (accessor.type != "SCALAR" || (type != uint8 && type != uint16 && type != uint32))
    return report_.error(path, fmt::format("indices cannot be {} of component type {}", accessor.type, type));
  if (accessor.view && document_[accessor.view].byte_stride > 0)
    report_.error(path, "the buffer view of indices must have no byteStride");
  if (accessor.view && document_[accessor.view].target == 34962)
    report_.warning(path, "its buffer view says that it holds vertices");
  if (!has_data(document_, accessor)) return;
  const std::vector<std::uint32_t> indices = read_whole(document_, accessor);
  const std::uint32_t highest = *std::max_element(indices.begin(), indices.end());
  const std::uint32_t restart = static_cast<std::uint32_t>((Whole{1} << 8 * component_bytes(type)) - 1);
  if (highest == restart) return report_.error(path, "it holds an index that would begin another primitive");
  if (highest >= vertices_)
    report_.error(path, fmt::format("it holds the index {}, but there are {} vertices", highest, vertices_));
}

void PrimitiveChecks::check_targets() {
  for (std::size_t i = 0; i < primitive_.targets.size(); ++i) {
    const std::string path = fmt::format("{}/targets/{}", path_, i);
    check_vertices(primitive_.targets[i], path);
    for (const auto& [name, ref] : primitive_.targets[i])
      if (!primitive_.attributes.contains(name))
        report_.error(path + "/" + name, "the primitive itself has no such attribute");
  }
}

void PrimitiveChecks::run() {
  if (primitive_.attributes.empty()) return;  // told before
  const auto position = primitive_.attributes.find("POSITION");
  vertices_ = document_[position != primitive_.attributes.end() ? position->second
                                                                : primitive_.attributes.begin()->second]
                  .count;
  if (position == primitive_.attributes.end())
    report_.warning(path_ + "/attributes", "it has no POSITION: nothing of it is seen");
  const std::size_t errors = report_.errors();
  check_vertices(primitive_.attributes, path_ + "/attributes");
  check_numbering(primitive_.attributes);
  check_targets();
  if (report_.errors() == errors && primitive_.indices) check_indices();
  if (primitive_.mode > 6)
    report_.error(path_ + "/mode", fmt::format("there is no mode {}", primitive_.mode));
}

void check_mappings(const Document& document, const Primitive& primitive, const std::string& path,
                    Report& report) {
  if (!primitive.variants) return;
  if (!document.variants) report.error(path, "it names material variants, but the file lists none");
  std::vector<Ref<List::variants>> seen;
  for (const VariantMapping& mapping : primitive.variants->mappings)
    for (const auto variant : mapping.variants) {
      if (among(seen, variant))
        report.error(path, fmt::format("variant {} stands there twice", variant.index));
      seen.push_back(variant);
    }
}

}  // namespace

void check_meshes(const Document& document, Report& report) {
  for (std::size_t m = 0; m < document.meshes.size(); ++m) {
    const MeshData& mesh = document.meshes[m];
    for (std::size_t p = 0; p < mesh.primitives.size(); ++p) {
      const std::string path = fmt::format("/meshes/{}/primitives/{}", m, p);
      PrimitiveChecks(document, mesh.primitives[p], path, report).run();
      check_mappings(document, mesh.primitives[p], path, report);
      if (mesh.primitives[p].targets.size() != mesh.primitives[0].targets.size())
        report.error(path + "/targets", "primitives of a mesh must have equally many morph targets");
    }
    if (!mesh.weights.empty() && !mesh.primitives.empty() &&
        mesh.weights.size() != mesh.primitives[0].targets.size())
      report.error(fmt::format("/meshes/{}/weights", m), "there must be one for each morph target");
  }
}

}  // namespace umbral::gltf
