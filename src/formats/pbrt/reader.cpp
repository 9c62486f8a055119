// One pbrt file with all that it includes.
#include "formats/pbrt/reader.h"

#include "formats/pbrt/directives.h"

namespace umbral::pbrt_file {

void read_scene(const std::filesystem::path& path, const IntegratorKinds& integrators, SceneBuilder& builder,
                SceneFile& result) {
  Directives directives(path, integrators, builder, result);
  directives.read(path, builder.files.read(path));
  directives.finish();
}

}  // namespace umbral::pbrt_file
