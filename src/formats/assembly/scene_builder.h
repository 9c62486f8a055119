// SceneBuilder: a scene in the making, with the place in the files that each part came from.
#pragma once

#include <filesystem>
#include <map>
#include <memory>
#include <mutex>
#include <string>
#include <tuple>
#include <vector>

#include "formats/assembly/named_camera.h"
#include "formats/input/diagnostics.h"
#include "formats/input/input_files.h"
#include "formats/read_options.h"
#include "image/images_ahead.h"
#include "scene/description.h"

namespace umbral {

// Shapes that stand together, in the world or in an object.
struct ShapeList {
  std::vector<Shape> shapes;
  std::vector<Place> places;  // one a shape

  void add(Shape shape, Place place) {
    shapes.push_back(std::move(shape));
    places.push_back(std::move(place));
  }
};

struct ObjectDraft {
  std::string name;
  ShapeList content;
};

class SceneBuilder {
 public:
  SceneBuilder(Diagnostics& diagnostics_, InputFiles& files_, ReadOptions options_ = {})
      : diagnostics(diagnostics_),
        files(files_),
        options(std::move(options_)),
        texture_memory(static_cast<std::size_t>(options.texture_memory)),
        images_ahead(options.on_images),
        memory_ahead_(static_cast<std::size_t>(options.texture_memory)) {}

  Diagnostics& diagnostics;
  InputFiles& files;
  ReadOptions options;
  std::vector<std::string> left_out;      // what lacks() was told
  std::vector<std::string> approximated;  // what approximates() was told

  CameraSettings camera;
  bool has_camera = false;
  std::vector<NamedCamera> cameras;  // those that files name
  std::vector<Texture> textures;     // prepared
  std::vector<Material> materials;
  std::vector<Place> material_places;  // one a material
  ShapeList world;
  std::vector<ObjectDraft> objects;
  std::vector<Instance> instances;
  std::vector<LightKinds> lights;
  std::optional<EnvironmentLight> environment;  // prepared

  // Makes it the scene's own if that has none yet.
  void add_camera(NamedCamera named);
  TextureId add(Texture texture);
  // What is wrong with its parts (formats/material_parts.h) is an error.
  MaterialId add(Material material, Place place);

  // What emitters reflect where they name no material: nothing.
  MaterialId black_material();

  // The image of that file, loaded once however often it is asked for. Repairs become warnings at `place`.
  // `with_levels`: with its levels of detail. Throws SceneError if the file cannot be read.
  std::shared_ptr<const TextureImage> image(const std::filesystem::path& file, ColorSpace space,
                                            const Place& place, bool with_levels = false);

  // Says that image() will be asked for that file. What was said until it first is decoded in parallel, as far as it fits
  // into the memory of textures; this saves time and changes nothing else.
  void expect_image(const std::filesystem::path& file, ColorSpace space);

  TextureMemory texture_memory;  // of all images
  ImagesAhead images_ahead;      // of expect_image(), and those that lie in other files

  // Tells of something in a file that umbral does not know: "a medium". An error; where the options are lenient it is
  // left out instead, which becomes a warning and part of the image's provenance.
  void lacks(const Place& place, const std::string& what);

  // Tells of something that umbral shows by a thing of its own that looks nearly the same: "Beckmann facets by GGX's". A
  // warning, and part of the image's provenance.
  void approximates(const Place& place, const std::string& what);

  // Moves everything out.
  SceneDescription finish();

 private:
  DecodedImage read_image(const std::string& file, ColorSpace space);

  std::mutex taking_;
  TextureMemory memory_ahead_;  // of what is expected; taken by one thread at a time
  MaterialId black_ = MaterialId::none;
  std::map<std::pair<std::filesystem::path, ColorSpace>, std::shared_ptr<TextureImage>> images_;
};

}  // namespace umbral
