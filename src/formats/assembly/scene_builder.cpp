// Parts of a scene as they come in.
#include "formats/assembly/scene_builder.h"

#include <stdexcept>

#include <fmt/format.h>

#include "formats/assembly/material_parts.h"
#include "image/texture_loader.h"

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
  if (const auto fault = fault_of_parts(material, materials)) diagnostics.error(place, *fault);
  materials.push_back(std::move(material));
  material_places.push_back(std::move(place));
  return static_cast<MaterialId>(materials.size() - 1);
}

MaterialId SceneBuilder::black_material() {
  if (black_ == MaterialId::none) black_ = add(Material{"black", Lambert{black}, {}, {1}}, {});
  return black_;
}

void SceneBuilder::expect_image(const std::filesystem::path& file, ColorSpace space) {
  const std::string name = file.string();
  images_ahead.expect({name, space}, [this, name, space] {
    std::vector<std::string> repairs;
    std::size_t bytes = 0;
    const auto take = [&](std::size_t wanted) {
      const std::lock_guard lock(taking_);
      return memory_ahead_.take(wanted);
    };
    std::optional<TextureImage> image = load_where_room(name, space, repairs, bytes, take);
    if (!image) throw std::length_error("there is no room for it");
    return DecodedImage{std::move(*image), std::move(repairs), bytes};
  });
}

DecodedImage SceneBuilder::read_image(const std::string& file, ColorSpace space) {
  std::optional<DecodedImage> ahead = images_ahead.take({file, space});
  if (ahead && texture_memory.take(ahead->budget)) return std::move(*ahead);
  std::vector<std::string> repairs;
  TextureImage image = load_texture_image(file, space, repairs, &texture_memory);
  return {std::move(image), std::move(repairs)};
}

std::shared_ptr<const TextureImage> SceneBuilder::image(const std::filesystem::path& file, ColorSpace space,
                                                        const Place& place, bool with_levels) {
  std::shared_ptr<TextureImage>& image = images_[{file, space}];
  if (!image) {
    files.add_to_hash(file);
    DecodedImage read = read_image(file.string(), space);
    image = std::make_shared<TextureImage>(std::move(read.image));
    for (const std::string& repair : read.repairs) diagnostics.warning(place, file.string() + ": " + repair);
  }
  if (with_levels && image->level_count() == 1) {
    if (texture_memory.take(image->memory() / 3))
      image->build_levels();
    else
      diagnostics.warning(place,
                          file.string() + ": there is no room for levels of detail; it is seen as it is");
  }
  return image;
}

void SceneBuilder::lacks(const Place& place, const std::string& what) {
  if (!options.lenient) {
    diagnostics.error(place, fmt::format("not supported: {}; --lenient leaves it out", what));
    return;
  }
  diagnostics.warning(place, fmt::format("left out: {}", what));
  left_out.push_back(fmt::format("{}:{}: {}", place.where.file, place.where.line, what));
}

void SceneBuilder::approximates(const Place& place, const std::string& what) {
  diagnostics.warning(place, fmt::format("approximated: {}", what));
  approximated.push_back(fmt::format("{}:{}: {}", place.where.file, place.where.line, what));
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
