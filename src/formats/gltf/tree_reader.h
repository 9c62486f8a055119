// TreeReader: JSON into described structs, with every error at its JSON path.
#pragma once

#include <set>
#include <string>

#include <nlohmann/json.hpp>

#include "formats/gltf/properties.h"
#include "formats/gltf/report.h"

namespace umbral::gltf {

using Json = nlohmann::json;

template <class T>
concept Described = requires {
  T::properties;
};
template <class T>
concept Extensible = requires {
  T::extensions;
};

class TreeReader {
 public:
  // `known_extensions` are those that are read somewhere: elsewhere they are errors.
  TreeReader(const Json& root, std::set<std::string> known_extensions, Report& report)
      : root_(root), known_(std::move(known_extensions)), report_(report) {}

  // Fills `object` from the whole file.
  template <Described T>
  void read(T& object) {
    read_value(root_, object, any_number);
  }

  // The extensions that objects carry, known or not.
  const std::set<std::string>& met_extensions() const { return met_; }

 private:
  // One step into the tree, for as long as it lives.
  class Step {
   public:
    Step(std::string& path, std::string_view key);
    ~Step() { path_.resize(length_); }
    Step(const Step&) = delete;
    Step& operator=(const Step&) = delete;

   private:
    std::string& path_;
    std::size_t length_;
  };

  void read_value(const Json& json, bool& value, const Range&);
  void read_value(const Json& json, std::string& value, const Range&);
  void read_value(const Json& json, double& value, const Range& range);
  void read_value(const Json& json, Whole& value, const Range& range);
  void read_index(const Json& json, std::uint32_t& index, List list);

  template <List list>
  void read_value(const Json& json, Ref<list>& ref, const Range&) {
    read_index(json, ref.index, list);
  }
  template <class T>
  void read_value(const Json& json, std::optional<T>& value, const Range& range) {
    read_value(json, value.emplace(), range);
  }
  template <class T, std::size_t n>
  void read_value(const Json& json, std::array<T, n>& values, const Range& range) {
    if (!is_list(json)) return;
    if (json.size() != n) return wrong_length(json.size(), n);
    for (std::size_t i = 0; i < n; ++i) {
      const Step step(path_, std::to_string(i));
      read_value(json[i], values[i], range);
    }
  }
  template <class T>
  void read_value(const Json& json, std::vector<T>& values, const Range& range) {
    if (!is_list(json)) return;
    if (json.empty()) empty("list");
    values.resize(json.size());
    for (std::size_t i = 0; i < json.size(); ++i) {
      const Step step(path_, std::to_string(i));
      read_value(json[i], values[i], range);
    }
  }
  template <class T>
  void read_value(const Json& json, std::map<std::string, T>& values, const Range& range) {
    if (!is_object(json)) return;
    if (json.empty()) empty("object");
    for (const auto& [key, item] : json.items()) {
      const Step step(path_, key);
      read_value(item, values[key], range);
    }
  }
  template <Described T>
  void read_value(const Json& json, T& object, const Range&) {
    if (!is_object(json)) return;
    std::apply([&](const auto&... p) { (read_property(json, object, p), ...); }, T::properties);
    std::set<std::string> names{"extensions", "extras"};
    std::apply([&](const auto&... p) { (names.insert(p.name), ...); }, T::properties);
    tell_unknown(json, names);
    read_extensions(json, object);
  }
  template <class T, class P>
  void read_property(const Json& json, T& object, const P& p) {
    const auto found = json.find(p.name);
    if (found == json.end()) {
      if (p.required) missing(p.name);
      return;
    }
    const Step step(path_, p.name);
    read_value(*found, object.*(P::member), p.range);
  }
  template <class T>
  void read_extensions(const Json& json, T& object) {
    const Json* extensions = extensions_of(json);
    if (!extensions) return;
    const Step step(path_, "extensions");
    std::set<std::string> names;
    if constexpr (Extensible<T>) {
      std::apply([&](const auto&... p) { (read_property(*extensions, object, p), ...); }, T::extensions);
      std::apply([&](const auto&... p) { (names.insert(p.name), ...); }, T::extensions);
    }
    tell_misplaced(*extensions, names);
  }

  bool is_list(const Json& json);
  bool is_object(const Json& json);
  void wrong_type(const Json& json, const char* wanted);
  void wrong_length(std::size_t length, std::size_t wanted);
  void empty(const char* what);
  void missing(const char* name);
  void tell_unknown(const Json& json, const std::set<std::string>& names);
  const Json* extensions_of(const Json& json);
  void tell_misplaced(const Json& extensions, const std::set<std::string>& names);

  const Json& root_;
  std::set<std::string> known_, met_;
  Report& report_;
  std::string path_;
};

}  // namespace umbral::gltf
