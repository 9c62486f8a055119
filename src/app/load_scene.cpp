// Wires the scene readers to the table of integrators.
#include "app/load_scene.h"

#ifdef __GLIBC__
#include <malloc.h>
#endif

#include <fmt/format.h>

#include "app/loading_progress.h"
#include "app/parameter_text.h"
#include "scene/relative_to_camera.h"

namespace umbral {

LoadedScene load_scene(const std::string& path, ReadOptions options, bool quiet) {
  LoadingProgress progress("reading " + path, quiet);
  options.on_images = [&](std::size_t done, std::size_t count) { progress.decoded(done, count); };
  LoadedScene loaded;
  IntegratorKinds kinds;
  for (const IntegratorEntry& entry : integrators()) kinds.kinds.push_back(entry.kind);
  kinds.default_kind = "path";
  kinds.read = [&](const std::string& kind, ParameterVisitor& visitor) {
    loaded.integrators[kind] = make_integrator(kind);
    loaded.integrators[kind]->describe(visitor);
  };
  loaded.file = read_scene_file(path, kinds, options);
#ifdef __GLIBC__
  malloc_trim(0);  // what reading took and left would stand beside the hierarchy of boxes while that is built
#endif
  return loaded;
}

void print_warnings(const SceneFile& file) {
  for (const Diagnostic& warning : file.warnings) fmt::print(stderr, "{}\n", warning.text());
}

Scene built_scene(SceneDescription description, bool quiet) {
  const LoadingProgress progress("building the scene", quiet);
  return Scene(relative_to_camera(std::move(description)));
}

std::string integrator_text(const std::string& kind, Integrator& integrator) {
  ParameterTexts texts;
  integrator.describe(texts);
  return call_text(kind, texts.texts());
}

}  // namespace umbral
