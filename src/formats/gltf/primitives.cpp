// Attributes and indices into a mesh; morph targets and skins.
#include "formats/gltf/primitives.h"

#include <algorithm>
#include <array>

#include <fmt/format.h>

#include "formats/gltf/accessors.h"

namespace umbral::gltf {
namespace {

enum Mode : Whole { triangles = 4, triangle_strip = 5, triangle_fan = 6 };

class PrimitiveReader {
 public:
  PrimitiveReader(const Document& document, const Primitive& primitive, const Pose& pose)
      : document_(document), primitive_(primitive), pose_(pose) {}

  Mesh read() {
    read_indices();
    mesh_.positions = vectors<Vec3>("POSITION");
    mesh_.normals = vectors<Vec3>("NORMAL");
    morph("POSITION", mesh_.positions);
    morph("NORMAL", mesh_.normals);
    if (!pose_.joints.empty()) skin();
    for (Vec3& normal : mesh_.normals) normal = glm::normalize(normal);  // clean() mends those of length 0
    mesh_.uvs = texture_coordinates("TEXCOORD_0");
    mesh_.uvs1 = texture_coordinates("TEXCOORD_1");
    read_colors();
    return std::move(mesh_);
  }

 private:
  const Accessor* attribute(const std::string& name) const {
    const auto found = primitive_.attributes.find(name);
    return found == primitive_.attributes.end() ? nullptr : &document_[found->second];
  }

  template <class T>
  std::vector<T> vectors(const std::string& name) const {
    const Accessor* accessor = attribute(name);
    return accessor ? read_vectors<T>(document_, *accessor) : std::vector<T>();
  }

  std::vector<Vec2> texture_coordinates(const std::string& name) const {
    std::vector<Vec2> uvs = vectors<Vec2>(name);
    for (Vec2& uv : uvs) uv.y = 1 - uv.y;
    return uvs;
  }

  void morph(const std::string& name, std::vector<Vec3>& values) const {
    const std::size_t count = std::min(pose_.weights.size(), primitive_.targets.size());
    for (std::size_t t = 0; t < count; ++t) {
      const auto found = primitive_.targets[t].find(name);
      const auto weight = static_cast<float>(pose_.weights[t]);
      if (weight == 0 || found == primitive_.targets[t].end()) continue;
      const std::vector<Vec3> target = read_vectors<Vec3>(document_, document_[found->second]);
      for (std::size_t i = 0; i < values.size(); ++i) values[i] += weight * target[i];
    }
  }

  void skin();
  void read_indices();
  void read_colors();

  const Document& document_;
  const Primitive& primitive_;
  const Pose& pose_;
  Mesh mesh_;
};

// Each vertex is moved by the weighted mean of its joints' matrices.
void PrimitiveReader::skin() {
  std::vector<Affine> moved(mesh_.positions.size(), Affine{glm::dmat3(0.0), Vec3d(0)});
  for (int set = 0; attribute(fmt::format("JOINTS_{}", set)); ++set) {
    const Accessor* weight_accessor = attribute(fmt::format("WEIGHTS_{}", set));
    if (!weight_accessor) break;
    const std::vector<std::uint32_t> joints =
        read_whole(document_, *attribute(fmt::format("JOINTS_{}", set)));
    const std::vector<float> weights = read_floats(document_, *weight_accessor);
    for (std::size_t i = 0; i < weights.size(); ++i) {
      const auto weight = static_cast<double>(weights[i]);
      if (weight == 0 || joints[i] >= pose_.joints.size()) continue;
      moved[i / 4].linear += weight * pose_.joints[joints[i]].linear;
      moved[i / 4].offset += weight * pose_.joints[joints[i]].offset;
    }
  }
  for (std::size_t i = 0; i < moved.size(); ++i) {
    mesh_.positions[i] = Vec3(moved[i].point(Vec3d(mesh_.positions[i])));
    if (!mesh_.normals.empty())
      mesh_.normals[i] = Vec3(glm::transpose(glm::inverse(moved[i].linear)) * Vec3d(mesh_.normals[i]));
  }
}

void PrimitiveReader::read_colors() {
  const Accessor* accessor = attribute("COLOR_0");
  if (!accessor) return;
  if (accessor->type == "VEC4") {
    mesh_.colors = read_vectors<glm::vec4>(document_, *accessor);
  } else {
    for (const Vec3& color : read_vectors<Vec3>(document_, *accessor)) mesh_.colors.emplace_back(color, 1.0f);
  }
  for (Spectrum& color : mesh_.colors) color = glm::clamp(color, 0.0f, 1.0f);
}

void PrimitiveReader::read_indices() {
  std::vector<std::uint32_t> indices;
  if (primitive_.indices) {
    indices = read_whole(document_, document_[primitive_.indices]);
  } else {
    indices.resize(attribute("POSITION")->count);
    for (std::size_t i = 0; i < indices.size(); ++i) indices[i] = static_cast<std::uint32_t>(i);
  }
  const std::size_t count = indices.size();
  mesh_.triangles.reserve(primitive_.mode == triangles ? count / 3 : count);
  if (primitive_.mode == triangles) {
    for (std::size_t i = 0; i + 2 < count; i += 3)
      mesh_.triangles.push_back({indices[i], indices[i + 1], indices[i + 2]});
  } else if (primitive_.mode == triangle_strip) {  // every second one is turned
    for (std::size_t i = 0; i + 2 < count; ++i)
      mesh_.triangles.push_back({indices[i], indices[i + 1 + i % 2], indices[i + 2 - i % 2]});
  } else {
    for (std::size_t i = 0; i + 2 < count; ++i)
      mesh_.triangles.push_back({indices[i + 1], indices[i + 2], indices[0]});
  }
}

bool is_there(const Document& document, const Primitive& primitive) {
  std::vector<Attributes> all = primitive.targets;
  all.push_back(primitive.attributes);
  if (primitive.indices) all.push_back({{"", primitive.indices}});
  for (const Attributes& attributes : all)
    for (const auto& [name, ref] : attributes)
      if (!has_data(document, document[ref])) return false;
  return true;
}

}  // namespace

std::optional<Mesh> mesh_of(const Document& document, const Primitive& primitive, const Pose& pose,
                            const std::string& path, Report& report) {
  static constexpr std::array names{"points", "lines", "a loop of lines", "a strip of lines"};
  if (primitive.mode < names.size()) {
    report.warning(path, fmt::format("it is {}, which are not shown", names[primitive.mode]));
    return std::nullopt;
  }
  if (!primitive.attributes.contains("POSITION")) return std::nullopt;  // told by the checks
  if (!is_there(document, primitive)) {
    report.error(path, "the data of an accessor is not there");
    return std::nullopt;
  }
  Mesh mesh = PrimitiveReader(document, primitive, pose).read();
  if (mesh.triangles.empty()) {
    report.warning(path, "it has no triangles");
    return std::nullopt;
  }
  return mesh;
}

}  // namespace umbral::gltf
