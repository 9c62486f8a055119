// From the nodes of a glTF file to shapes, instances, lights and cameras.
#include "formats/gltf/scene.h"

#include <algorithm>
#include <map>
#include <set>

#include <fmt/format.h>

#include "formats/assembly/place_shape.h"
#include "formats/gltf/accessors.h"
#include "formats/gltf/document_reader.h"
#include "formats/gltf/looks.h"
#include "formats/gltf/placements.h"
#include "formats/gltf/primitives.h"
#include "formats/gltf/viewing.h"

namespace umbral {
namespace gltf {
namespace {

class Scene {
 public:
  Scene(const Document& document, SceneBuilder& builder, const std::filesystem::path& path,
        const Inclusion& inclusion, ShapeList& shapes, Report& report)
      : document_(document),
        builder_(builder),
        to_world_(inclusion.to_world),
        shapes_(shapes),
        report_(report),
        looks_(document, builder, path.parent_path(), inclusion.overrides, report),
        place_{{path.string()}} {}

  std::vector<std::string> add();

 private:
  bool is_world() const { return &shapes_ == &builder_.world; }
  std::vector<Affine> places_of(const PlacedNode& placed) const;
  bool is_own(const Node& node) const;
  void expect_images(const std::vector<PlacedNode>& nodes);
  void add_mesh(const PlacedNode& placed);
  void add_shapes(const Node& node, const Affine& to_world, const std::vector<Affine>& joints,
                  ShapeList& shapes);
  ObjectId object_of(const Node& node);
  std::vector<Affine> joints_of(const Skin& skin) const;

  const Document& document_;
  SceneBuilder& builder_;
  const Affine& to_world_;
  ShapeList& shapes_;
  Report& report_;
  Looks looks_;
  Place place_;
  std::vector<Affine> transforms_;             // of all nodes; filled where there are skins
  std::vector<std::size_t> uses_;              // of each mesh
  std::map<std::uint32_t, ObjectId> objects_;  // by mesh
};

// Whether the node's mesh is in a pose that other nodes do not share.
bool Scene::is_own(const Node& node) const { return node.skin || !node.weights.empty(); }

std::vector<Affine> Scene::places_of(const PlacedNode& placed) const {
  const Node& node = document_.nodes[placed.node];
  std::vector<Affine> places{to_world_ * placed.to_scene};
  if (!node.instancing || node.instancing->attributes.empty()) return places;
  const std::vector<Affine> inner = instance_transforms(document_, *node.instancing);
  const Affine outer = places[0];
  places.clear();
  for (const Affine& transform : inner) places.push_back(outer * transform);
  return places;
}

std::vector<Affine> Scene::joints_of(const Skin& skin) const {
  std::vector<float> values;
  if (skin.inverse_bind_matrices) values = read_floats(document_, document_[skin.inverse_bind_matrices]);
  std::vector<Affine> joints;
  for (std::size_t j = 0; j < skin.joints.size(); ++j) {
    Affine bind;
    if (const float* m = values.empty() ? nullptr : values.data() + 16 * j)
      bind = {glm::dmat3(m[0], m[1], m[2], m[4], m[5], m[6], m[8], m[9], m[10]), {m[12], m[13], m[14]}};
    joints.push_back(transforms_[skin.joints[j].index] * bind);
  }
  return joints;
}

void Scene::add_shapes(const Node& node, const Affine& to_world, const std::vector<Affine>& joints,
                       ShapeList& shapes) {
  const MeshData& data = document_[node.mesh];
  const std::string& name = data.name.empty() ? node.name : data.name;
  const Pose pose{node.weights.empty() ? data.weights : node.weights, joints};
  for (std::size_t p = 0; p < data.primitives.size(); ++p) {
    const std::string path = fmt::format("/meshes/{}/primitives/{}", node.mesh.index, p);
    auto mesh = mesh_of(document_, data.primitives[p], pose, path, report_);
    if (!mesh) continue;
    const Look& look = looks_.of(data.primitives[p]);
    Shape shape{name, std::move(*mesh), to_world, look.material, look.emission, look.two_sided};
    Diagnostics repairs;
    const auto fault = place_shape(std::move(shape), place_, repairs, shapes);
    for (const Diagnostic& repair : repairs.warnings()) report_.warning(path, repair.message);
    if (fault) report_.warning(path, fmt::format("it is not shown: {}", fault->message));
  }
}

ObjectId Scene::object_of(const Node& node) {
  const auto known = objects_.find(node.mesh.index);
  if (known != objects_.end()) return known->second;
  ObjectDraft object{document_[node.mesh].name, {}};
  add_shapes(node, Affine{}, {}, object.content);
  ObjectId id{no_index};
  if (!object.content.shapes.empty()) {
    id = static_cast<ObjectId>(builder_.objects.size());
    builder_.objects.push_back(std::move(object));
  }
  return objects_.emplace(node.mesh.index, id).first->second;
}

// Those of all meshes, so that they are decoded in parallel.
void Scene::expect_images(const std::vector<PlacedNode>& nodes) {
  std::set<std::uint32_t> meshes, materials;
  for (const PlacedNode& placed : nodes) {
    const Ref<List::meshes> mesh = document_.nodes[placed.node].mesh;
    if (!mesh || !meshes.insert(mesh.index).second) continue;
    for (const Primitive& primitive : document_[mesh].primitives)
      if (materials.insert(primitive.material.index).second) looks_.expect_images(primitive.material);
  }
  builder_.images_ahead.decode_expected();
}

void Scene::add_mesh(const PlacedNode& placed) {
  const Node& node = document_.nodes[placed.node];
  if (node.skin) {  // joints alone place a skin
    add_shapes(node, to_world_, joints_of(document_[node.skin]), shapes_);
    return;
  }
  for (const Affine& to_world : places_of(placed)) {
    const double size = std::abs(to_world.determinant());
    if (!is_world() || is_own(node) || uses_[node.mesh.index] < 2 || !(size > 0)) {
      add_shapes(node, to_world, {}, shapes_);
    } else if (const ObjectId object = object_of(node); object != ObjectId{no_index}) {
      builder_.instances.push_back({object, to_world});
    }
  }
}

std::vector<std::string> Scene::add() {
  const std::vector<PlacedNode> nodes = placed_nodes(document_, report_);
  if (!document_.skins.empty()) transforms_ = node_transforms(document_);
  uses_.resize(document_.meshes.size());
  expect_images(nodes);
  for (const PlacedNode& placed : nodes) {
    const Node& node = document_.nodes[placed.node];
    if (node.mesh && !is_own(node)) uses_[node.mesh.index] += places_of(placed).size();
  }
  for (const PlacedNode& placed : nodes) {
    const Node& node = document_.nodes[placed.node];
    if (node.mesh) add_mesh(placed);
    if (node.light && is_world())
      add_light(document_[node.light->light], to_world_ * placed.to_scene, builder_, report_);
    if (node.camera && is_world())
      add_camera(document_, placed.node, to_world_ * placed.to_scene, builder_, report_);
  }
  if (!document_.animations.empty())
    report_.warning("/animations", "the scene is shown as its nodes stand, without its animations");
  return {looks_.names().begin(), looks_.names().end()};
}

}  // namespace
}  // namespace gltf

std::vector<std::string> add_gltf(SceneBuilder& builder, const std::filesystem::path& path,
                                  const Place& place, const Inclusion& inclusion, ShapeList& shapes) {
  gltf::Report report(builder.diagnostics, path.string());
  std::vector<std::string> names;
  try {
    if (const auto document = gltf::read_document(path, builder.files, report))
      names = gltf::Scene(*document, builder, path, inclusion, shapes, report).add();
  } catch (const SceneError& error) {
    builder.diagnostics.error(place, error);
  }
  report.finish();
  return names;
}

}  // namespace umbral
