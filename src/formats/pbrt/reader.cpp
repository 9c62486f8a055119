// One pbrt file with all that it includes.
#include "formats/pbrt/reader.h"

#include "formats/pbrt/directives.h"

namespace umbral::pbrt_file {

void read_scene(const std::filesystem::path& path, const IntegratorKinds& integrators, SceneBuilder& builder,
                SceneFile& result) {
  Directives directives(path, {}, integrators, builder, result);
  directives.read(path, builder.files.read(path));
  directives.finish();
}

std::vector<std::string> add_scene(SceneBuilder& builder, const std::filesystem::path& path,
                                   const Inclusion& inclusion) {
  const IntegratorKinds no_integrators;
  SceneFile no_settings;
  Directives directives(path, inclusion, no_integrators, builder, no_settings);
  directives.read(path, builder.files.read(path));
  directives.finish();
  return directives.materials_seen();
}

}  // namespace umbral::pbrt_file
