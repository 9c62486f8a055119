// LightReader: the lights of a document that are no shapes.
#pragma once

#include <filesystem>
#include <initializer_list>
#include <optional>

#include "formats/assembly/scene_builder.h"
#include "formats/toml/table_reader.h"

namespace umbral::toml_file {

class LightReader {
 public:
  // Files are relative to `folder`.
  LightReader(const Context& context, SceneBuilder& builder, std::filesystem::path folder)
      : context_(context), builder_(builder), folder_(std::move(folder)) {}

  // Reads a list [[lights]].
  void read(const Value& list);

 private:
  void read_light(const Value& item, const Value::Table& entries);
  void read_environment(TableReader& table);
  void read_sky(TableReader& table);
  // The key 'transform': to the frame of a light's image, where it is given; an error where it does more than turn and mirror.
  std::optional<Mat3> image_from_world(TableReader& table);
  bool claims_environment(const TableReader& table);
  // Where `idle`, each of the keys that is there is an error: it has no effect, and why.
  void tell_idle(TableReader& table, std::initializer_list<const char*> names, bool idle,
                 const char* why) const;
  // Of lights that have one; false where it could not be read, which is then reported.
  template <class Light>
  bool load_image(TableReader& table, Light& light);
  // The image of a light's 'file'; none where it could not be read, which is then reported.
  std::shared_ptr<const TextureImage> image(TableReader& table, const std::string& file);

  const Context& context_;
  SceneBuilder& builder_;
  std::filesystem::path folder_;
  std::optional<int> environment_line_;
};

}  // namespace umbral::toml_file
