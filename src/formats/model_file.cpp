// Choice of the reader by the file's name; meshes without materials, scenes without their settings.
#include "formats/model_file.h"

#include <fmt/format.h>

#include "formats/assembly/place_shape.h"
#include "formats/gltf/scene.h"
#include "formats/meshes/mesh_file.h"
#include "formats/mitsuba/reader.h"
#include "formats/obj/obj_scene.h"
#include "formats/pbrt/reader.h"

namespace umbral {
namespace {

void add_mesh(SceneBuilder& builder, const std::filesystem::path& path, const Place& place,
              const Inclusion& inclusion, ShapeList& shapes) {
  std::optional<Mesh> mesh = read_mesh_file(builder, path, place);
  if (!mesh) return;
  const std::optional<MaterialId>& material = inclusion.overrides.all;
  if (!material)
    builder.diagnostics.warning({{path.string()}}, "the file names no material: it is matte grey (0.5)");
  Shape shape{path.filename().string(), std::move(*mesh), inclusion.to_world,
              material ? *material : builder.add(Material{"grey", Lambert{grey(0.5f)}, {}, {1}}, place)};
  const auto fault = place_shape(std::move(shape), place, builder.diagnostics, shapes);
  if (fault) builder.diagnostics.error(place, fault->message);
}

std::vector<std::string> add_scene(SceneBuilder& builder, const std::filesystem::path& path,
                                   const Place& place, const Inclusion& inclusion, const ShapeList& shapes) {
  if (&shapes != &builder.world) {
    builder.diagnostics.error(place, "a scene of pbrt or Mitsuba comes into the world alone: [[include]]");
    return {};
  }
  try {
    return file_kind(path) == FileKind::pbrt ? pbrt_file::add_scene(builder, path, inclusion)
                                             : mitsuba_file::add_scene(builder, path, inclusion);
  } catch (const SceneError& error) {
    builder.diagnostics.error(place, error);
    return {};
  }
}

}  // namespace

std::string model_endings() { return ".gltf, .glb, .obj, .ply or .stl"; }

bool is_plain_mesh(const std::filesystem::path& path) {
  const FileKind kind = file_kind(path);
  return kind == FileKind::ply || kind == FileKind::stl;
}

std::vector<std::string> add_model(SceneBuilder& builder, const std::filesystem::path& path,
                                   const Place& place, const Inclusion& inclusion, ShapeList& shapes) {
  switch (file_kind(path)) {
    case FileKind::gltf:
      return add_gltf(builder, path, place, inclusion, shapes);
    case FileKind::obj:
      return add_obj(builder, path, place, inclusion, shapes);
    case FileKind::ply:
    case FileKind::stl:
      add_mesh(builder, path, place, inclusion, shapes);
      return {};
    case FileKind::pbrt:
    case FileKind::mitsuba:
      return add_scene(builder, path, place, inclusion, shapes);
    default:
      builder.diagnostics.error(place, fmt::format("the name of '{}' must end in .pbrt, .xml, {}",
                                                   path.filename().string(), model_endings()));
      return {};
  }
}

}  // namespace umbral
