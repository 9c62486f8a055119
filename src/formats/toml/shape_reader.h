// ShapeReader: the shapes and includes of a document.
#pragma once

#include <filesystem>
#include <map>

#include "formats/assembly/scene_builder.h"
#include "formats/toml/name_table.h"
#include "formats/toml/texture_library.h"

namespace umbral::toml_file {

class ShapeReader {
 public:
  // Files are relative to `folder`.
  ShapeReader(const Context& context, SceneBuilder& builder, TextureLibrary& textures,
              NameTable<MaterialId>& materials, std::filesystem::path folder)
      : context_(context),
        builder_(builder),
        textures_(textures),
        materials_(materials),
        folder_(std::move(folder)) {}

  // Appends the shapes of a list [[shapes]].
  void read_shapes(const Value& list, ShapeList& shapes);
  // Appends the shapes of the files of a list [[include]].
  void read_includes(const Value& list, ShapeList& shapes);

 private:
  void read_shape(const Value& item, const Value::Table& table, ShapeList& shapes);
  bool read_kind(TableReader& table, ShapeKinds& kind);
  void read_emission(TableReader& table, Shape& shape);
  std::optional<MaterialId> read_material(TableReader& table, bool emits);
  void read_include(const Value& item, const Value::Table& table, ShapeList& shapes);
  std::map<std::string, MaterialId> read_overrides(const Value::Table& entries);
  void check_overrides(const Value::Table& entries, const std::vector<std::string>& names) const;

  const Context& context_;
  SceneBuilder& builder_;
  TextureLibrary& textures_;
  NameTable<MaterialId>& materials_;
  std::filesystem::path folder_;
};

}  // namespace umbral::toml_file
