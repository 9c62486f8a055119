// One shape of a document after the other.
#include "formats/toml/shape_reader.h"

#include <fmt/format.h>

#include "core/kinds.h"
#include "formats/assembly/place_shape.h"
#include "formats/meshes/mesh_file.h"
#include "formats/toml/mesh.h"
#include "formats/toml/parameter_reader.h"
#include "formats/toml/transform.h"

namespace umbral::toml_file {

void ShapeReader::read_shapes(const Value& list, ShapeList& shapes) {
  for_each_table(context_, list, "shapes",
                 [&](const Value& item, const Value::Table& table) { read_shape(item, table, shapes); });
}

void ShapeReader::read_shape(const Value& item, const Value::Table& entries, ShapeList& shapes) {
  TableReader table(context_, &entries, "shape", context_.place(item));
  const auto kind = table.find_kind("shape", kind_names<ShapeKinds>());
  if (!kind) return;
  table.rename(*kind);
  Shape shape{"", *make_kind<ShapeKinds>(*kind), {}};
  bool good = read_kind(table, shape.kind);
  if (const auto* name = table.find_as<std::string>("name", "a string")) shape.name = *name;
  read_emission(table, shape);
  const auto material = read_material(table, table.has("emission"));
  shape.to_world = read_transform(table);
  table.finish();
  if (!good || !material) return;
  shape.material = *material;
  if (const auto fault = place_shape(std::move(shape), table.place(), context_.diagnostics, shapes)) {
    const Value* blamed = table.find(fault->key);
    context_.diagnostics.error(blamed ? context_.place(*blamed) : table.place(), fault->message);
  }
}

bool ShapeReader::read_kind(TableReader& table, ShapeKinds& kind) {
  ParameterReader parameters(table, nullptr);
  std::visit([&](auto& value) { for_each_parameter(value, parameters); }, kind);
  auto* mesh = std::get_if<Mesh>(&kind);
  if (!mesh) return true;
  if (!table.has("file")) return read_written_mesh(table, *mesh);
  refuse_written_mesh(table);
  if (mesh->file.empty()) return false;
  const Place place = context_.place(*table.find("file"));
  const auto read = read_mesh_file(builder_, (folder_ / mesh->file).lexically_normal(), place);
  if (!read) return false;
  const std::string file = mesh->file;
  *mesh = *read;
  mesh->file = file;
  return true;
}

void ShapeReader::read_emission(TableReader& table, Shape& shape) {
  ParameterReader parameters(table, &textures_);
  parameters(ParameterInfo{"emission", "radiance, W m⁻² sr⁻¹", non_negative}, shape.emission);
  parameters(ParameterInfo{"two_sided", "emits on the inner side too"}, shape.two_sided);
  if (table.has("two_sided") && !table.has("emission"))
    context_.error(*table.find_entry("two_sided"), "'two_sided' has no effect on a shape without 'emission'");
}

std::optional<MaterialId> ShapeReader::read_material(TableReader& table, bool emits) {
  if (const Value* value = table.find("material")) return materials_.find(*value);
  if (emits) return builder_.black_material();
  table.missing("material");
  return std::nullopt;
}

}  // namespace umbral::toml_file
