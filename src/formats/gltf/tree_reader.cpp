// The plain values of a glTF file's JSON, and what to say of wrong ones.
#include "formats/gltf/tree_reader.h"

#include <cmath>

#include <fmt/format.h>

namespace umbral::gltf {
namespace {

// The name of a value's type in a message.
std::string type_of(const Json& json) {
  if (json.is_number()) return "a number";
  if (json.is_string()) return "text";
  if (json.is_array()) return "a list";
  if (json.is_object()) return "an object";
  return json.is_null() ? "null" : "true or false";
}

std::string range_text(const Range& range) {
  const auto end = [](float x) { return std::abs(x) >= 0x1p53f ? "infinity" : fmt::format("{}", x); };
  if (range.high == infinity || range.high == 0x1p53f)
    return fmt::format("{} {}", range.low_open ? "above" : "at least", end(range.low));
  return fmt::format("between {} and {}", end(range.low), end(range.high));
}

}  // namespace

TreeReader::Step::Step(std::string& path, std::string_view key) : path_(path), length_(path.size()) {
  path_ += '/';
  for (const char c : key) {  // as JSON pointers are written [RFC 6901]
    if (c == '~')
      path_ += "~0";
    else if (c == '/')
      path_ += "~1";
    else
      path_ += c;
  }
}

void TreeReader::read_value(const Json& json, bool& value, const Range&) {
  if (!json.is_boolean()) return wrong_type(json, "true or false");
  value = json.get<bool>();
}

void TreeReader::read_value(const Json& json, std::string& value, const Range&) {
  if (!json.is_string()) return wrong_type(json, "text");
  value = json.get<std::string>();
}

void TreeReader::read_value(const Json& json, double& value, const Range& range) {
  if (!json.is_number()) return wrong_type(json, "a number");
  const double number = json.get<double>();
  if (!std::isfinite(static_cast<float>(number)))
    return report_.error(path_, fmt::format("{} is too large", number));
  if (!range.contains(static_cast<float>(number)))
    return report_.error(path_, fmt::format("it must be {}, but is {}", range_text(range), number));
  value = number;
}

// Whole numbers may be written as 3.0.
void TreeReader::read_value(const Json& json, Whole& value, const Range& range) {
  if (!json.is_number()) return wrong_type(json, "a whole number");
  const double number = json.get<double>();
  if (number != std::floor(number) || !(number >= 0 && number <= 0x1p53))
    return report_.error(path_, fmt::format("it must be a whole number of 0 or more, but is {}", number));
  if (!range.contains(number))
    return report_.error(path_, fmt::format("it must be {}, but is {}", range_text(range), number));
  value = static_cast<Whole>(number);
}

void TreeReader::read_index(const Json& json, std::uint32_t& index, List list) {
  Whole number = 0;
  const std::size_t errors = report_.errors();
  read_value(json, number, whole);
  if (report_.errors() > errors) return;
  const std::string pointer = list_pointers[static_cast<std::size_t>(list)];
  const Json* items = nullptr;
  try {
    items = &root_.at(Json::json_pointer(pointer));
  } catch (const Json::exception&) {
  }
  const std::size_t count = items && items->is_array() ? items->size() : 0;
  if (number >= count)
    return report_.error(path_, fmt::format("there is no {}/{}: the file has {}", pointer, number,
                                            count == 0 ? "none" : fmt::format("{}", count)));
  index = static_cast<std::uint32_t>(number);
}

bool TreeReader::is_list(const Json& json) {
  if (!json.is_array()) wrong_type(json, "a list");
  return json.is_array();
}

bool TreeReader::is_object(const Json& json) {
  if (!json.is_object()) wrong_type(json, "an object");
  return json.is_object();
}

void TreeReader::wrong_type(const Json& json, const char* wanted) {
  report_.error(path_, fmt::format("it must be {}, but is {}", wanted, type_of(json)));
}

void TreeReader::wrong_length(std::size_t length, std::size_t wanted) {
  report_.error(path_, fmt::format("it must be a list of {} values, but has {}", wanted, length));
}

void TreeReader::empty(const char* what) {
  report_.warning(path_, fmt::format("an empty {}, which glTF forbids, is taken as absent", what));
}

void TreeReader::missing(const char* name) { report_.error(path_, fmt::format("'{}' is missing", name)); }

void TreeReader::tell_unknown(const Json& json, const std::set<std::string>& names) {
  for (const auto& [key, item] : json.items())
    if (!names.contains(key))
      report_.warning(path_, fmt::format("'{}' is no property of glTF here and is not used", key));
}

const Json* TreeReader::extensions_of(const Json& json) {
  const auto found = json.find("extensions");
  if (found == json.end()) return nullptr;
  const Step step(path_, "extensions");
  if (!is_object(*found)) return nullptr;
  for (const auto& [name, item] : found->items()) {
    met_.insert(name);
    if (item.is_object() || known_.contains(name)) continue;
    const Step inner(path_, name);
    wrong_type(item, "an object");
  }
  return &*found;
}

void TreeReader::tell_misplaced(const Json& extensions, const std::set<std::string>& names) {
  for (const auto& [name, item] : extensions.items())
    if (known_.contains(name) && !names.contains(name))
      report_.error(path_, fmt::format("the extension {} does not belong here", name));
}

}  // namespace umbral::gltf
