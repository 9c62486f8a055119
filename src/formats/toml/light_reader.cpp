// One light of a document after the other.
#include "formats/toml/light_reader.h"

#include <fmt/format.h>

#include "core/kinds.h"
#include "formats/toml/parameter_reader.h"

namespace umbral::toml_file {
namespace {

struct LightFault {
  const char* key;
  const char* message;
};

std::optional<LightFault> fault_of(const LightKinds& light) {
  if (const auto* distant = std::get_if<DistantLight>(&light); distant && distant->direction == Vec3(0))
    return LightFault{"direction", "'direction' of 'distant' has no direction"};
  if (const auto* spot = std::get_if<SpotLight>(&light); spot && spot->position == spot->target)
    return LightFault{"target", "'target' of 'spot' is its 'position': it has no axis"};
  return std::nullopt;
}

}  // namespace

void LightReader::read(const Value& list) {
  for_each_table(context_, list, "lights",
                 [&](const Value& item, const Value::Table& entries) { read_light(item, entries); });
}

void LightReader::read_light(const Value& item, const Value::Table& entries) {
  TableReader table(context_, &entries, "light", context_.place(item));
  std::vector<std::string> kinds = kind_names<LightKinds>();
  kinds.emplace_back(EnvironmentLight::kind);
  const auto kind = table.find_kind("light", kinds);
  if (!kind) return;
  table.rename(*kind);
  if (*kind == EnvironmentLight::kind) return read_environment(table);
  LightKinds light = *make_kind<LightKinds>(*kind);
  ParameterReader parameters(table, nullptr);
  std::visit([&](auto& value) { for_each_parameter(value, parameters); }, light);
  table.finish();
  if (const auto fault = fault_of(light)) {
    const Value* blamed = table.find(fault->key);
    return context_.diagnostics.error(blamed ? context_.place(*blamed) : table.place(), fault->message);
  }
  builder_.lights.push_back(light);
}

void LightReader::read_environment(TableReader& table) {
  EnvironmentLight light;
  ParameterReader parameters(table, nullptr);
  for_each_parameter(light, parameters);
  table.finish();
  const int line = table.place().where.line;
  if (environment_line_)
    return context_.diagnostics.error(
        table.place(),
        fmt::format("there can be one environment only; another is in line {}", *environment_line_));
  environment_line_ = line;
  if (table.has("rotation") && !table.has("file"))
    context_.error(*table.find_entry("rotation"),
                   "'rotation' has no effect on an environment without 'file'");
  if (!light.file.empty()) {
    const Place place = context_.place(*table.find("file"));
    try {
      light.image = builder_.image((folder_ / light.file).lexically_normal(), ColorSpace::automatic, place);
    } catch (const SceneError& error) {
      context_.diagnostics.error(place, error);
    }
  }
  light.prepare();
  builder_.environment = std::move(light);
}

}  // namespace umbral::toml_file
