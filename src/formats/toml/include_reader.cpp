// Shapes of a document that come from OBJ and PLY files with their materials.
#include <algorithm>

#include <fmt/format.h>

#include "core/names.h"
#include "formats/mesh_file.h"
#include "formats/obj/obj_scene.h"
#include "formats/place_shape.h"
#include "formats/toml/shape_reader.h"
#include "formats/toml/transform.h"

namespace umbral::toml_file {

void ShapeReader::read_includes(const Value& list, ShapeList& shapes) {
  for_each_table(context_, list, "include",
                 [&](const Value& item, const Value::Table& table) { read_include(item, table, shapes); });
}

std::map<std::string, MaterialId> ShapeReader::read_overrides(const Value::Table& entries) {
  std::map<std::string, MaterialId> overrides;
  for (const Entry& entry : entries)
    if (const auto id = materials_.find(entry.value)) overrides.emplace(entry.key, *id);
  return overrides;
}

void ShapeReader::read_include(const Value& item, const Value::Table& entries, ShapeList& shapes) {
  TableReader table(context_, &entries, "include", context_.place(item));
  const auto* file = table.find_as<std::string>("file", "a string");
  if (!table.has("file")) table.missing("file");
  const Value* material = table.find("material");
  const auto* by_name = table.find_as<Value::Table>("materials", "a table {name_in_the_file = \"our name\"}");
  MaterialOverrides overrides;
  if (material) overrides.all = materials_.find(*material);
  if (by_name) overrides.by_name = read_overrides(*by_name);
  const Affine to_world = read_transform(table);
  table.finish();
  if (!file) return;
  const std::filesystem::path path = (folder_ / *file).lexically_normal();
  const Place place = context_.place(*table.find("file"));
  switch (file_kind(path)) {
    case FileKind::obj: {
      const std::vector<std::string> names = add_obj(builder_, path, place, to_world, overrides, shapes);
      if (by_name) check_overrides(*by_name, names);
      break;
    }
    case FileKind::ply:
      if (!material) table.missing("material");
      if (by_name)
        context_.error(*table.find_entry("materials"),
                       "'materials' has no effect: a PLY file names no materials");
      if (overrides.all) include_ply(path, place, to_world, *overrides.all, shapes);
      break;
    default:
      context_.diagnostics.error(place, fmt::format("'{}' is neither an .obj nor a .ply file", *file));
  }
}

void ShapeReader::check_overrides(const Value::Table& entries, const std::vector<std::string>& names) const {
  for (const Entry& entry : entries)
    if (std::find(names.begin(), names.end(), entry.key) == names.end())
      context_.error(entry, fmt::format("no face of the file uses a material '{}'{}", entry.key,
                                        suggestion(entry.key, names)));
}

void ShapeReader::include_ply(const std::filesystem::path& path, const Place& place, const Affine& to_world,
                              MaterialId material, ShapeList& shapes) {
  std::optional<Mesh> mesh = read_mesh_file(builder_, path, place);
  if (!mesh) return;
  Shape shape{path.filename().string(), std::move(*mesh), to_world, material};
  if (const auto fault = place_shape(std::move(shape), place, context_.diagnostics, shapes))
    context_.diagnostics.error(place, fault->message);
}

}  // namespace umbral::toml_file
