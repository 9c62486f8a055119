// Transforms of nodes.
#include "formats/gltf/placements.h"

#include <fmt/format.h>
#include <glm/gtc/quaternion.hpp>

#include "formats/gltf/accessors.h"

namespace umbral::gltf {
namespace {

Affine affine_of(const Vec3d& translation, const glm::dvec4& rotation, const Vec3d& scale) {
  const double length = glm::length(rotation);
  const glm::dquat turn(rotation.w / length, rotation.x / length, rotation.y / length, rotation.z / length);
  const Affine turned{length > 0 ? glm::mat3_cast(turn) : glm::dmat3(1.0), translation};
  return turned * scaling(scale);
}

Affine local_transform(const Node& node) {
  if (node.matrix) {
    const std::array<double, 16>& m = *node.matrix;
    return {glm::dmat3(m[0], m[1], m[2], m[4], m[5], m[6], m[8], m[9], m[10]), {m[12], m[13], m[14]}};
  }
  const auto t = node.translation.value_or(std::array{0.0, 0.0, 0.0});
  const auto r = node.rotation.value_or(std::array{0.0, 0.0, 0.0, 1.0});
  const auto s = node.scale.value_or(std::array{1.0, 1.0, 1.0});
  return affine_of({t[0], t[1], t[2]}, {r[0], r[1], r[2], r[3]}, {s[0], s[1], s[2]});
}

// Nodes that are no node's children.
std::vector<Ref<List::nodes>> roots(const Document& document) {
  std::vector<bool> is_child(document.nodes.size());
  for (const Node& node : document.nodes)
    for (const auto child : node.children) is_child[child.index] = true;
  std::vector<Ref<List::nodes>> found;
  for (std::uint32_t i = 0; i < document.nodes.size(); ++i)
    if (!is_child[i]) found.push_back({i});
  return found;
}

// Visits the trees in the order of the file; `enter` says whether to go on below.
template <class Enter>
void walk(const Document& document, const std::vector<Ref<List::nodes>>& trees, Enter enter) {
  std::vector<PlacedNode> open;
  const auto push = [&](const std::vector<Ref<List::nodes>>& nodes, const Affine& parent) {
    for (auto node = nodes.rbegin(); node != nodes.rend(); ++node)
      open.push_back({node->index, parent * local_transform(document[*node])});
  };
  push(trees, Affine{});
  while (!open.empty()) {
    const PlacedNode placed = open.back();
    open.pop_back();
    if (enter(placed)) push(document.nodes[placed.node].children, placed.to_scene);
  }
}

}  // namespace

std::vector<PlacedNode> placed_nodes(const Document& document, Report& report) {
  std::vector<Ref<List::nodes>> trees;
  if (document.scenes.empty()) {
    report.warning("", "it has no scene: all of its nodes are shown");
    trees = roots(document);
  } else {
    const std::size_t shown = document.scene ? document.scene.index : 0;
    if (document.scenes.size() > 1)
      report.warning("/scene",
                     fmt::format("of its {} scenes, number {} is shown", document.scenes.size(), shown));
    trees = document.scenes[shown].nodes;
  }
  std::vector<PlacedNode> placed;
  walk(document, trees, [&](const PlacedNode& node) {
    const auto& visibility = document.nodes[node.node].visibility;
    if (visibility && !visibility->visible) return false;
    placed.push_back(node);
    return true;
  });
  return placed;
}

std::vector<Affine> node_transforms(const Document& document) {
  std::vector<Affine> transforms(document.nodes.size());
  walk(document, roots(document), [&](const PlacedNode& node) {
    transforms[node.node] = node.to_scene;
    return true;
  });
  return transforms;
}

std::vector<Affine> instance_transforms(const Document& document, const GpuInstancing& instancing) {
  const auto accessor = [&](const char* name) -> const Accessor* {
    const auto found = instancing.attributes.find(name);
    return found == instancing.attributes.end() ? nullptr : &document[found->second];
  };
  const Accessor *t = accessor("TRANSLATION"), *r = accessor("ROTATION"), *s = accessor("SCALE");
  std::size_t count = 0;
  for (const auto& [name, ref] : instancing.attributes) count = document[ref].count;
  std::vector<Vec3> translations(count, Vec3(0)), scales(count, Vec3(1));
  std::vector<glm::vec4> rotations(count, glm::vec4(0, 0, 0, 1));
  if (t) translations = read_vectors<Vec3>(document, *t);
  if (r) rotations = read_vectors<glm::vec4>(document, *r);
  if (s) scales = read_vectors<Vec3>(document, *s);
  std::vector<Affine> transforms(count);
  for (std::size_t i = 0; i < count; ++i)
    transforms[i] = affine_of(Vec3d(translations[i]), glm::dvec4(rotations[i]), Vec3d(scales[i]));
  return transforms;
}

}  // namespace umbral::gltf
