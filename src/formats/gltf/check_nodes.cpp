// Checks of the hierarchy of nodes, their transforms and skins.
#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "formats/gltf/accessors.h"
#include "formats/gltf/checks.h"

namespace umbral::gltf {
namespace {

class NodeChecks {
 public:
  NodeChecks(const Document& document, Report& report)
      : document_(document), report_(report), parents_(document.nodes.size(), no_index) {}

  void run();

 private:
  static std::string path_of(std::size_t node) { return fmt::format("/nodes/{}", node); }
  void find_parents();
  void find_loops();
  void check_transform(const Node& node, const std::string& path);
  void check_parts(const Node& node, const std::string& path);
  void check_instancing(const Node& node, const std::string& path);
  void check_skin_of(const Node& node, const std::string& path);
  void check_scenes();
  void check_skin(const Skin& skin, const std::string& path);
  std::uint32_t root_of(std::uint32_t node) const;
  bool is_above(std::uint32_t above, std::uint32_t node) const;

  const Document& document_;
  Report& report_;
  std::vector<std::uint32_t> parents_;
  bool loops_ = false;
};

void NodeChecks::find_parents() {
  for (std::size_t i = 0; i < document_.nodes.size(); ++i)
    for (const auto child : document_.nodes[i].children) {
      std::uint32_t& parent = parents_[child.index];
      if (parent != no_index)
        report_.error(path_of(i) + "/children",
                      fmt::format("node {} is a child of node {} already", child.index, parent));
      parent = static_cast<std::uint32_t>(i);
    }
}

void NodeChecks::find_loops() {
  std::vector<bool> clear(parents_.size());  // the way up from it ends
  for (std::size_t i = 0; i < parents_.size(); ++i) {
    std::vector<std::size_t> way;
    std::size_t node = i;
    while (!clear[node] && parents_[node] != no_index && way.size() <= parents_.size()) {
      way.push_back(node);
      node = parents_[node];
    }
    if (way.size() > parents_.size()) {
      loops_ = true;
      return report_.error(path_of(i), "it is a part of itself: nodes must form trees");
    }
    clear[node] = true;
    for (const std::size_t passed : way) clear[passed] = true;
  }
}

void NodeChecks::check_transform(const Node& node, const std::string& path) {
  if (node.matrix && (node.translation || node.rotation || node.scale))
    report_.error(path, "it has a 'matrix' and a translation, rotation or scale besides");
  if (node.rotation) {
    double square = 0;
    for (const double x : *node.rotation) square += x * x;
    if (square == 0)
      report_.error(path + "/rotation", "a quaternion of length 0 is no rotation");
    else if (std::abs(std::sqrt(square) - 1) > 0.00769)  // what a signed byte can be off
      report_.warning(
          path + "/rotation",
          fmt::format("its quaternion has the length {:.5g}; it is taken as 1", std::sqrt(square)));
  }
  if (!node.matrix) return;
  const std::array<double, 16>& m = *node.matrix;
  if (m[3] != 0 || m[7] != 0 || m[11] != 0 || m[15] != 1)
    report_.error(path + "/matrix", "its last row must be 0 0 0 1");
  const Vec3d x(m[0], m[1], m[2]), y(m[4], m[5], m[6]), z(m[8], m[9], m[10]);
  const double skew = std::max({std::abs(dot(x, y)) / (glm::length(x) * glm::length(y)),
                                std::abs(dot(y, z)) / (glm::length(y) * glm::length(z)),
                                std::abs(dot(z, x)) / (glm::length(z) * glm::length(x))});
  if (skew > 1e-4)
    report_.warning(path + "/matrix", "it shears, which glTF forbids; it is used as it stands");
}

void NodeChecks::check_skin_of(const Node& node, const std::string& path) {
  if (!node.mesh) return report_.error(path + "/skin", "it has a skin, but no mesh");
  const auto& primitives = document_[node.mesh].primitives;
  for (const Primitive& primitive : primitives)
    if (!primitive.attributes.contains("JOINTS_0"))
      return report_.error(path + "/skin", "the mesh of a node with a skin must have JOINTS_0 and WEIGHTS_0");
}

void NodeChecks::check_instancing(const Node& node, const std::string& path) {
  std::optional<Whole> count;
  for (const auto& [name, ref] : node.instancing->attributes) {
    const Accessor& accessor = document_[ref];
    const std::string at = path + "/extensions/EXT_mesh_gpu_instancing/attributes/" + name;
    const bool known = name == "TRANSLATION" || name == "ROTATION" || name == "SCALE";
    if (!known && !name.starts_with('_')) report_.warning(at, "this attribute is unknown and not used");
    if (known && accessor.type != (name == "ROTATION" ? "VEC4" : "VEC3"))
      report_.error(at, fmt::format("it cannot be {}", accessor.type));
    if (count.value_or(accessor.count) != accessor.count)
      report_.error(at, fmt::format("it has {} instances, but others have {}", accessor.count, *count));
    if (!layout_of(accessor) || !has_data(document_, accessor)) report_.error(at, "its data is not there");
    count = accessor.count;
  }
}

void NodeChecks::check_parts(const Node& node, const std::string& path) {
  if (node.skin) check_skin_of(node, path);
  if (!node.weights.empty() && !node.mesh)
    report_.error(path + "/weights", "it has weights, but no mesh");
  else if (!node.weights.empty() && !document_[node.mesh].primitives.empty() &&
           document_[node.mesh].primitives[0].targets.size() != node.weights.size())
    report_.error(path + "/weights", "there must be one for each morph target of its mesh");
  if (node.instancing) check_instancing(node, path);
}

std::uint32_t NodeChecks::root_of(std::uint32_t node) const {
  while (parents_[node] != no_index) node = parents_[node];
  return node;
}

bool NodeChecks::is_above(std::uint32_t above, std::uint32_t node) const {
  while (node != no_index && node != above) node = parents_[node];
  return node == above;
}

void NodeChecks::check_skin(const Skin& skin, const std::string& path) {
  if (skin.inverse_bind_matrices) {
    const Accessor& accessor = document_[skin.inverse_bind_matrices];
    const std::string at = path + "/inverseBindMatrices";
    if (accessor.type != "MAT4" || accessor.component_type != float32)
      report_.error(at, "it must be MAT4 of floats");
    else if (!has_data(document_, accessor))
      report_.error(at, "its data is not there");
    if (accessor.view && document_[accessor.view].byte_stride > 0)
      report_.error(at, "its buffer view must have no byteStride");
    if (accessor.count < skin.joints.size())
      report_.error(at, fmt::format("it has {} matrices for {} joints", accessor.count, skin.joints.size()));
  }
  if (loops_ || skin.joints.empty()) return;
  for (const auto joint : skin.joints) {
    if (root_of(joint.index) != root_of(skin.joints[0].index))
      return report_.warning(path + "/joints", "its joints have no root in common");
    if (skin.skeleton && !is_above(skin.skeleton.index, joint.index))
      return report_.warning(path + "/skeleton", "it is not above every joint");
  }
}

void NodeChecks::check_scenes() {
  for (std::size_t s = 0; s < document_.scenes.size(); ++s)
    for (std::size_t i = 0; i < document_.scenes[s].nodes.size(); ++i) {
      const std::uint32_t node = document_.scenes[s].nodes[i].index;
      if (parents_[node] != no_index)
        report_.error(fmt::format("/scenes/{}/nodes/{}", s, i),
                      fmt::format("node {} is a child of node {}, not a root", node, parents_[node]));
    }
}

void NodeChecks::run() {
  find_parents();
  find_loops();
  for (std::size_t i = 0; i < document_.nodes.size(); ++i) {
    check_transform(document_.nodes[i], path_of(i));
    check_parts(document_.nodes[i], path_of(i));
  }
  check_scenes();
  for (std::size_t i = 0; i < document_.skins.size(); ++i)
    check_skin(document_.skins[i], fmt::format("/skins/{}", i));
}

}  // namespace

void check_nodes(const Document& document, Report& report) { NodeChecks(document, report).run(); }

void check_document(const Document& document, Report& report) {
  const std::size_t errors = report.errors();
  check_data(document, report);
  if (report.errors() > errors) return;  // the others look into the data
  check_meshes(document, report);
  check_nodes(document, report);
  check_looks(document, report);
}

}  // namespace umbral::gltf
