// Wires the scene readers to the table of integrators.
#include "app/load_scene.h"

#include "app/parameter_text.h"
#include "core/hash.h"
#include "formats/input_files.h"

namespace umbral {

LoadedScene load_scene(const std::string& path, const ReadOptions& options) {
  LoadedScene loaded;
  IntegratorKinds kinds;
  for (const IntegratorEntry& entry : integrators()) kinds.kinds.push_back(entry.kind);
  kinds.default_kind = "path";
  kinds.read = [&](const std::string& kind, ParameterVisitor& visitor) {
    loaded.integrators[kind] = make_integrator(kind);
    loaded.integrators[kind]->describe(visitor);
  };
  loaded.file = read_scene_file(path, kinds, options);
  return loaded;
}

void replace_environment(SceneFile& file, const std::string& image_path) {
  EnvironmentLight environment;
  environment.file = image_path;
  std::vector<std::string> repairs;
  environment.image =
      std::make_shared<TextureImage>(load_texture_image(image_path, ColorSpace::automatic, repairs));
  environment.prepare();
  for (const std::string& repair : repairs)
    file.warnings.push_back(Diagnostic{Severity::warning, Where{image_path, 0, 0}, repair, {}});
  InputFiles hashed;
  hashed.add_to_hash(image_path);
  file.hash = hash_combine(file.hash, hashed.hash());
  file.scene.environment = std::move(environment);
}

std::string integrator_text(const std::string& kind, Integrator& integrator) {
  ParameterTexts texts;
  integrator.describe(texts);
  return call_text(kind, texts.texts());
}

}  // namespace umbral
