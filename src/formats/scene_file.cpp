// The readers of scene files, chosen by the file's name.
#include "formats/scene_file.h"

#include <algorithm>
#include <cmath>

#include "formats/assembly/checks.h"
#include "formats/assembly/framing.h"
#include "formats/file_contents.h"
#include "formats/meshes/mesh_file.h"
#include "formats/mitsuba/reader.h"
#include "formats/model_file.h"
#include "formats/pbrt/reader.h"
#include "formats/toml/scene_reader.h"

namespace umbral {

namespace {

void replace_environment(SceneBuilder& builder) {
  const std::string& file = builder.options.environment;
  EnvironmentLight environment;
  environment.file = file;
  environment.image = builder.image(file, ColorSpace::automatic, {{file}});
  environment.prepare();
  if (!(environment.power(1) > 0)) throw SceneError(Where{file}, "the image is black: no light");
  builder.environment = std::move(environment);
}

}  // namespace

void take_aspect(float aspect, FilmSettings& film) {
  const double pixels = static_cast<double>(film.width) * film.height;
  const auto side = [&](double ratio) {
    return static_cast<int>(std::lround(std::clamp(std::sqrt(pixels * ratio), 1.0, 65536.0)));
  };
  film.width = side(static_cast<double>(aspect));
  film.height = side(1 / static_cast<double>(aspect));
}

SceneFile read_scene_file(const std::filesystem::path& path, const IntegratorKinds& integrators,
                          const ReadOptions& options) {
  SceneFile result;
  InputFiles files;
  Diagnostics diagnostics;
  diagnostics.name_file(path.string());
  SceneBuilder builder(diagnostics, files, options);
  if (!options.environment.empty()) builder.expect_image(options.environment, ColorSpace::automatic);
  const Place place{{path.string()}};
  const FileKind kind = file_kind(path);
  if (const auto fault = fault_of_contents(path)) throw SceneError(place.where, *fault);
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
    if (kind == FileKind::unknown)
      diagnostics.error(place, "the name of a scene file must end in .toml, .pbrt, .xml, " + model_endings());
    else
      add_model(builder, path, place, {}, builder.world);
    if (!builder.cameras.empty() && builder.cameras.front().aspect > 0)
      take_aspect(builder.cameras.front().aspect, result.film);
  }
  const bool empty = builder.world.shapes.empty() && builder.instances.empty() && !builder.environment;
  if (kind != FileKind::toml && empty && !diagnostics.has_errors())
    diagnostics.error(place, "there is nothing to see: the file has no surface and no environment");
  diagnostics.throw_errors();
  if (!options.environment.empty()) replace_environment(builder);
  const bool is_model = kind != FileKind::toml && kind != FileKind::pbrt && kind != FileKind::mitsuba;
  // glTF's emission without KHR_materials_emissive_strength, up to 1, is what shows of labels and unlit surfaces.
  const float brightest_label = kind == FileKind::gltf ? 1.0f : 0.0f;
  complete_scene(builder, static_cast<double>(result.film.width) / result.film.height, place,
                 is_model ? std::optional(brightest_label) : std::nullopt);
  check_scene(builder, place);
  diagnostics.throw_errors();
  result.cameras = builder.cameras;
  result.scene = builder.finish();
  result.warnings = diagnostics.warnings();
  result.left_out = std::move(builder.left_out);
  result.approximated = std::move(builder.approximated);
  result.hash = files.hash();
  return result;
}

}  // namespace umbral
