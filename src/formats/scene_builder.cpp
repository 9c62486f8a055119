// Parts of a scene as they come in.
#include "formats/scene_builder.h"

namespace umbral {

void SceneBuilder::add_camera(NamedCamera named) {
  if (!has_camera) camera = named.settings;
  has_camera = true;
  cameras.push_back(std::move(named));
}

TextureId SceneBuilder::add(Texture texture) {
  textures.push_back(std::move(texture));
  return static_cast<TextureId>(textures.size() - 1);
}

MaterialId SceneBuilder::add(Material material, Place place) {
  materials.push_back(std::move(material));
  material_places.push_back(std::move(place));
  return static_cast<MaterialId>(materials.size() - 1);
}

MaterialId SceneBuilder::black_material() {
  if (black_ == MaterialId::none) black_ = add(Material{"black", Lambert{black}, {}, {1}}, {});
  return black_;
}

std::shared_ptr<const TextureImage> SceneBuilder::image(const std::filesystem::path& file, ColorSpace space,
                                                        const Place& place) {
  std::shared_ptr<const TextureImage>& image = images_[{file, space}];
  if (image) return image;
  files.add_to_hash(file);
  std::vector<std::string> repairs;
  image = std::make_shared<TextureImage>(load_texture_image(file.string(), space, repairs));
  for (const std::string& repair : repairs) diagnostics.warning(place, file.string() + ": " + repair);
  return image;
}

SceneDescription SceneBuilder::finish() {
  SceneDescription scene;
  scene.camera = camera;
  scene.textures = std::move(textures);
  scene.materials = std::move(materials);
  scene.shapes = std::move(world.shapes);
  for (ObjectDraft& object : objects)
    scene.objects.push_back({std::move(object.name), std::move(object.content.shapes)});
  scene.instances = std::move(instances);
  scene.lights = std::move(lights);
  scene.environment = std::move(environment);
  return scene;
}

}  // namespace umbral
