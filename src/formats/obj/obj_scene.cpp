// From the lists of an OBJ file to shapes with materials.
#include "formats/obj/obj_scene.h"

#include <algorithm>
#include <set>
#include <system_error>

#include <fmt/format.h>

#include "core/names.h"
#include "formats/assembly/place_shape.h"
#include "formats/obj/mtl_materials.h"
#include "formats/obj/obj_meshes.h"

namespace umbral {
namespace {

class ObjScene {
 public:
  ObjScene(SceneBuilder& builder, const std::filesystem::path& path, const Place& place,
           const MaterialOverrides& overrides)
      : builder_(builder), path_(path), place_(place), overrides_(overrides) {}

  std::vector<std::string> add(const Affine& to_world, ShapeList& shapes);

 private:
  void read_libraries();
  void read_library(const std::string& name, const Place& place);
  MtlLook look(std::uint32_t material);
  const MtlMaterial* in_library(const std::string& name) const;
  MtlLook new_look(const ObjName& name, std::optional<MaterialId> override);
  void add_mesh(ObjMesh mesh, const Affine& to_world, ShapeList& shapes);

  SceneBuilder& builder_;
  const std::filesystem::path& path_;
  const Place& place_;
  const MaterialOverrides& overrides_;
  ObjFile file_;
  std::vector<MtlMaterial> library_;           // of all its libraries
  std::set<std::filesystem::path> libraries_;  // that were read
  std::map<std::uint32_t, MtlLook> looks_;     // by number in file_.materials
};

std::vector<std::string> ObjScene::add(const Affine& to_world, ShapeList& shapes) {
  std::vector<ObjMesh> meshes;
  {
    const auto source = std::make_shared<const SourceText>(path_.string(), builder_.files.read(path_));
    TextErrors errors(builder_.diagnostics, source);
    file_ = parse_obj(source->text(), errors);
    if (!errors.any()) meshes = obj_meshes(file_, ObjGrouping::by_material, errors);
    if (errors.any()) return {};
  }
  read_libraries();
  for (const ObjMesh& mesh : meshes) {
    const std::string& name = file_.materials[mesh.material].name;
    if (const MtlMaterial* mtl = in_library(name))
      expect_images(*mtl, overrides_.find(name), builder_, path_.parent_path());
  }
  const std::size_t before = shapes.shapes.size();
  std::vector<std::string> names;
  for (ObjMesh& mesh : meshes) {
    const std::string& name = file_.materials[mesh.material].name;
    if (!name.empty()) names.push_back(name);
    add_mesh(std::move(mesh), to_world, shapes);
  }
  if (shapes.shapes.size() == before && !builder_.diagnostics.has_errors())
    builder_.diagnostics.error({{path_.string()}}, "the file has no face with an area");
  return names;
}

void ObjScene::add_mesh(ObjMesh mesh, const Affine& to_world, ShapeList& shapes) {
  const Place place{{path_.string(), mesh.line, 0}};
  const MtlLook look = this->look(mesh.material);
  const std::string& name = file_.materials[mesh.material].name;
  Shape shape{name.empty() ? path_.filename().string() : name, std::move(mesh.mesh), to_world, look.material,
              look.emission};
  const bool empty = std::get<Mesh>(shape.kind).triangles.empty();
  const auto fault = place_shape(std::move(shape), place, builder_.diagnostics, shapes);
  if (!fault) return;
  if (empty || std::string(fault->key) == "file")
    builder_.diagnostics.warning(place, fmt::format("no face of material '{}' has an area", name));
  else
    builder_.diagnostics.error(place_, fault->message);
}

// The name may have spaces; only if there is no such file it is a list of names.
void ObjScene::read_libraries() {
  std::error_code absent;
  for (const ObjName& library : file_.libraries) {
    if (std::filesystem::is_regular_file(path_.parent_path() / library.name, absent)) {
      read_library(library.name, library.place);
      continue;
    }
    std::string name, part;
    for (const char c : library.name + ' ') {
      if (c == ' ' && name.ends_with('\\')) {
        name.back() = ' ';
      } else if (c != ' ' && c != '\t') {
        name += c;
      } else if (!name.empty()) {
        read_library(name, library.place);
        name.clear();
      }
    }
  }
}

void ObjScene::read_library(const std::string& name, const Place& place) {
  const std::filesystem::path path = (path_.parent_path() / name).lexically_normal();
  if (!libraries_.insert(path).second) return;
  try {
    const auto source = std::make_shared<const SourceText>(path.string(), builder_.files.read(path));
    TextErrors errors(builder_.diagnostics, source);
    for (MtlMaterial& material : parse_mtl(source->text(), errors)) library_.push_back(std::move(material));
  } catch (const SceneError& error) {
    builder_.diagnostics.warning(place, error);
  }
}

const MtlMaterial* ObjScene::in_library(const std::string& name) const {
  const auto found = std::find_if(library_.begin(), library_.end(),
                                  [&](const MtlMaterial& material) { return material.name == name; });
  return found == library_.end() ? nullptr : &*found;
}

MtlLook ObjScene::look(std::uint32_t material) {
  const auto known = looks_.find(material);
  if (known != looks_.end()) return known->second;
  const ObjName& name = file_.materials[material];
  return looks_.emplace(material, new_look(name, overrides_.find(name.name))).first->second;
}

MtlLook ObjScene::new_look(const ObjName& name, std::optional<MaterialId> override) {
  if (const MtlMaterial* mtl = in_library(name.name))
    return look_of(*mtl, override, builder_, path_.parent_path());
  if (override) return {*override};
  std::vector<std::string> names;
  for (const MtlMaterial& material : library_) names.push_back(material.name);
  if (name.name.empty())
    builder_.diagnostics.warning({{path_.string()}}, "faces without a material are matte grey (0.5)");
  else
    builder_.diagnostics.warning(
        name.place, fmt::format("there is no material '{}', so its faces are matte grey (0.5){}", name.name,
                                suggestion(name.name, names)));
  return {builder_.add(Material{name.name, Lambert{grey(0.5f)}, {}, {1}}, name.place)};
}

}  // namespace

std::vector<std::string> add_obj(SceneBuilder& builder, const std::filesystem::path& path, const Place& place,
                                 const Inclusion& inclusion, ShapeList& shapes) {
  try {
    return ObjScene(builder, path, place, inclusion.overrides).add(inclusion.to_world, shapes);
  } catch (const SceneError& error) {
    builder.diagnostics.error(place, error);
    return {};
  }
}

}  // namespace umbral
