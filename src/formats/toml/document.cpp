// The tree made from what toml++ parsed; the only file that includes it.
#include "formats/toml/document.h"

#include <algorithm>
#include <tuple>

#include <toml++/toml.h>

namespace umbral::toml_file {
namespace {

Value converted(const toml::node& node);

Value::Table converted_table(const toml::table& table) {
  Value::Table entries;
  for (const auto& [key, node] : table) {
    const toml::source_position begin = key.source().begin;
    entries.push_back({std::string(key.str()), static_cast<int>(begin.line), static_cast<int>(begin.column),
                       converted(node)});
  }
  std::sort(entries.begin(), entries.end(), [](const Entry& a, const Entry& b) {
    return std::tuple(a.line, a.column) < std::tuple(b.line, b.column);
  });
  return entries;
}

Value converted(const toml::node& node) {
  Value value;
  value.line = static_cast<int>(node.source().begin.line);
  value.column = static_cast<int>(node.source().begin.column);
  if (const toml::table* table = node.as_table()) {
    value.data = converted_table(*table);
  } else if (const toml::array* array = node.as_array()) {
    Value::Array items;
    items.reserve(array->size());
    for (const toml::node& item : *array) items.push_back(converted(item));
    value.data = std::move(items);
  } else if (node.is_string()) {
    value.data = node.as_string()->get();
  } else if (node.is_integer()) {
    value.data = node.as_integer()->get();
  } else if (node.is_floating_point()) {
    value.data = node.as_floating_point()->get();
  } else if (node.is_boolean()) {
    value.data = node.as_boolean()->get();
  } else {
    value.data = DateOrTime{};
  }
  return value;
}

// toml++ begins with what it was doing, which the excerpt shows.
std::string without_preamble(std::string_view description) {
  const std::size_t colon = description.find(": ");
  const bool preamble = description.starts_with("Error while parsing") && colon != std::string_view::npos;
  return std::string(preamble ? description.substr(colon + 2) : description);
}

}  // namespace

std::optional<double> Value::number() const {
  if (const std::int64_t* integer = as<std::int64_t>()) return static_cast<double>(*integer);
  if (const double* real = as<double>()) return *real;
  return std::nullopt;
}

const char* Value::type_name() const {
  static constexpr const char* names[] = {"a boolean", "a number", "a number",      "a string",
                                          "a list",    "a table",  "a date or time"};
  return names[data.index()];
}

Value parse(const std::shared_ptr<const SourceText>& source) {
  try {
    return converted(toml::parse(source->text(), source->name()));
  } catch (const toml::parse_error& error) {
    const toml::source_position begin = error.source().begin;
    const Place place{{source->name(), static_cast<int>(begin.line), static_cast<int>(begin.column)}, source};
    throw SceneError(
        {{Severity::error, place.where, without_preamble(error.description()), place.excerpt()}});
  }
}

}  // namespace umbral::toml_file
