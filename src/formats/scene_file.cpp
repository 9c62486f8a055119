// The readers of scene files, chosen by the file's name.
#include "formats/scene_file.h"

#include "formats/checks.h"
#include "formats/framing.h"
#include "formats/mesh_file.h"
#include "formats/mitsuba/reader.h"
#include "formats/obj/obj_scene.h"
#include "formats/pbrt/reader.h"
#include "formats/place_shape.h"
#include "formats/toml/scene_reader.h"

namespace umbral {
namespace {

void add_ply(const std::filesystem::path& path, const Place& place, SceneBuilder& builder) {
  std::optional<Mesh> mesh = read_mesh_file(builder, path, place);
  if (!mesh) return;
  const MaterialId material = builder.add(Material{"grey", Lambert{grey(0.5f)}, {}, {1}}, place);
  builder.diagnostics.warning(place, "a PLY file names no material: it is matte grey (0.5)");
  Shape shape{path.filename().string(), std::move(*mesh), {}, material};
  const auto fault = place_shape(std::move(shape), place, builder.diagnostics, builder.world);
  if (fault) builder.diagnostics.error(place, fault->message);
}

}  // namespace

SceneFile read_scene_file(const std::filesystem::path& path, const IntegratorKinds& integrators,
                          const ReadOptions& options) {
  SceneFile result;
  InputFiles files;
  Diagnostics diagnostics;
  diagnostics.name_file(path.string());
  SceneBuilder builder(diagnostics, files, options);
  const Place place{{path.string()}};
  const FileKind kind = file_kind(path);
  if (!options.definitions.empty() && kind != FileKind::mitsuba)
    diagnostics.error(place, "-D has no effect: only Mitsuba files have parameters");
  if (kind == FileKind::toml) {
    const auto source = std::make_shared<const SourceText>(path.string(), files.read(path));
    toml_file::read_scene(source, path.parent_path(), integrators, builder, result);
  } else if (kind == FileKind::pbrt) {
    pbrt_file::read_scene(path, integrators, builder, result);
  } else if (kind == FileKind::mitsuba) {
    mitsuba_file::read_scene(path, integrators, builder, result);
  } else {
    toml_file::read_no_settings(integrators, diagnostics, result);
    if (kind == FileKind::obj) add_obj(builder, path, place, Affine{}, {}, builder.world);
    if (kind == FileKind::ply) add_ply(path, place, builder);
    if (kind == FileKind::unknown)
      diagnostics.error(place, "the name of a scene file must end in .toml, .pbrt, .xml, .obj or .ply");
  }
  diagnostics.throw_errors();
  const bool is_model = kind == FileKind::obj || kind == FileKind::ply;
  complete_scene(builder, static_cast<double>(result.film.width) / result.film.height, is_model, place);
  check_scene(builder, place);
  result.scene = builder.finish();
  result.warnings = diagnostics.warnings();
  result.left_out = std::move(builder.left_out);
  result.hash = files.hash();
  return result;
}

}  // namespace umbral
