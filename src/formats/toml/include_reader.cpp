// Parts of a document that come from files of other programs, with their materials.
#include <algorithm>

#include <fmt/format.h>

#include "core/names.h"
#include "formats/file_contents.h"
#include "formats/model_file.h"
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
  Inclusion inclusion;
  if (material) inclusion.overrides.all = materials_.find(*material);
  if (by_name) inclusion.overrides.by_name = read_overrides(*by_name);
  inclusion.to_world = read_transform(table);
  table.finish();
  if (!file) return;
  const std::filesystem::path path = (folder_ / *file).lexically_normal();
  const Place place = context_.place(*table.find("file"));
  if (const auto fault = fault_of_contents(path))
    return context_.diagnostics.error(place, SceneError(Where{path.string()}, *fault));
  if (is_plain_mesh(path)) {
    if (by_name)
      context_.error(*table.find_entry("materials"),
                     "'materials' has no effect: the file names no materials");
    if (!material) return table.missing("material");
  }
  const std::vector<std::string> names = add_model(builder_, path, place, inclusion, shapes);
  const bool failed = names.empty() && context_.diagnostics.has_errors();
  if (by_name && !failed && !is_plain_mesh(path)) check_overrides(*by_name, names);
}

void ShapeReader::check_overrides(const Value::Table& entries, const std::vector<std::string>& names) const {
  for (const Entry& entry : entries)
    if (std::find(names.begin(), names.end(), entry.key) == names.end())
      context_.error(entry, fmt::format("no face of the file uses a material '{}'{}", entry.key,
                                        suggestion(entry.key, names)));
}

}  // namespace umbral::toml_file
