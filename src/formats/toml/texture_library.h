// TextureLibrary: the textures of a document, by name or written where they are used.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "formats/assembly/scene_builder.h"
#include "formats/toml/name_table.h"
#include "formats/toml/table_reader.h"

namespace umbral::toml_file {

class TextureLibrary {
 public:
  // Image files are relative to `folder`.
  TextureLibrary(const Context& context, SceneBuilder& builder, std::filesystem::path folder)
      : context_(context), builder_(builder), folder_(std::move(folder)), named_(context, "texture") {}

  // Makes the section [textures] known: each is read when it is first asked for, or by read_rest().
  void open_section(const Value& section);
  void read_rest() { named_.read_rest(); }

  // Who asks from now on, for messages on files that cannot be read: "material 'gold'".
  void set_asker(std::string asker) { asker_ = std::move(asker); }

  // The texture that `value` names or holds, for the parameter `info`, whose range its values must keep.
  // None where it is no good, which has been told.
  std::optional<TextureId> find(const Value& value, const ParameterInfo& info, bool as_color);

  // Tells the named textures that nothing used.
  void report_unused() const { named_.report_unused(); }

 private:
  std::optional<TextureId> read(const Value::Table& table, std::string name, const Place& place);
  bool check(const Texture& texture, TableReader& table) const;
  bool load_image(ImageTexture& texture, TableReader& table);
  void load_tiles(ImageTexture& texture, const Place& place);
  bool keeps_range(const Value& value, const ParameterInfo& info, const Texture& texture,
                   bool as_color) const;
  // Whether it is, or is made from, one whose uv is bent (scene/textures/projected_texture.h).
  bool bends(const Texture& texture) const;
  bool suits_normals(const Value& value, const Texture& texture) const;

  const Context& context_;
  SceneBuilder& builder_;
  std::filesystem::path folder_;
  NameTable<TextureId> named_;
  std::string asker_;
};

}  // namespace umbral::toml_file
