// Choice of the reader by the file's name; meshes without materials.
#include "formats/model_file.h"

#include <fmt/format.h>

#include "formats/assembly/place_shape.h"
#include "formats/gltf/scene.h"
#include "formats/meshes/mesh_file.h"
#include "formats/obj/obj_scene.h"

namespace umbral {
namespace {

void add_mesh(SceneBuilder& builder, const std::filesystem::path& path, const Place& place,
              const Affine& to_world, const MaterialOverrides& overrides, ShapeList& shapes) {
  std::optional<Mesh> mesh = read_mesh_file(builder, path, place);
  if (!mesh) return;
  if (!overrides.all)
    builder.diagnostics.warning({{path.string()}}, "the file names no material: it is matte grey (0.5)");
  const MaterialId material =
      overrides.all ? *overrides.all : builder.add(Material{"grey", Lambert{grey(0.5f)}, {}, {1}}, place);
  Shape shape{path.filename().string(), std::move(*mesh), to_world, material};
  const auto fault = place_shape(std::move(shape), place, builder.diagnostics, shapes);
  if (fault) builder.diagnostics.error(place, fault->message);
}

}  // namespace

std::string model_endings() { return ".gltf, .glb, .obj, .ply or .stl"; }

bool is_plain_mesh(const std::filesystem::path& path) {
  const FileKind kind = file_kind(path);
  return kind == FileKind::ply || kind == FileKind::stl;
}

std::vector<std::string> add_model(SceneBuilder& builder, const std::filesystem::path& path,
                                   const Place& place, const Affine& to_world,
                                   const MaterialOverrides& overrides, ShapeList& shapes) {
  switch (file_kind(path)) {
    case FileKind::gltf:
      return add_gltf(builder, path, place, to_world, overrides, shapes);
    case FileKind::obj:
      return add_obj(builder, path, place, to_world, overrides, shapes);
    case FileKind::ply:
    case FileKind::stl:
      add_mesh(builder, path, place, to_world, overrides, shapes);
      return {};
    default:
      builder.diagnostics.error(
          place, fmt::format("the name of '{}' must end in {}", path.filename().string(), model_endings()));
      return {};
  }
}

}  // namespace umbral
