// NameTable: the named things of one section, and which of them were used.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "core/names.h"
#include "formats/toml/table_reader.h"

namespace umbral::toml_file {

template <class Id>
class NameTable {
 public:
  // `noun` is what messages call a thing: "texture".
  NameTable(const Context& context, const char* noun) : context_(context), noun_(noun) {}

  // `id` is none where the thing is broken, which has been told.
  void add(const Entry& entry, std::optional<Id> id) { things_.push_back({&entry, id, false}); }

  // What `value` names; none, and told, where there is no such thing.
  std::optional<Id> find(const Value& value) {
    const auto* name = value.as<std::string>();
    if (!name) {
      context_.error(value,
                     fmt::format("the name of a {} must be a string, not {}", noun_, value.type_name()));
      return std::nullopt;
    }
    for (Thing& thing : things_) {
      if (thing.entry->key != *name) continue;
      thing.used = true;
      return thing.id;
    }
    std::vector<std::string> names;
    for (const Thing& thing : things_) names.push_back(thing.entry->key);
    context_.error(value, fmt::format("there is no {} '{}'{}", noun_, *name, suggestion(*name, names)));
    take_as_used(nearest_name(*name, names));
    return std::nullopt;
  }

  // Tells what nothing used.
  void report_unused() const {
    for (const Thing& thing : things_)
      if (!thing.used)
        context_.error(*thing.entry, fmt::format("nothing uses {} '{}'", noun_, thing.entry->key));
  }

  // Calls read(entry, table) for every table of the section; anything else in it is an error.
  template <class Read>
  void read_section(const Value& section, Read&& read) {
    const auto* entries = section.as<Value::Table>();
    if (!entries) return context_.error(section, fmt::format("write {0}s as [{0}s.NAME]", noun_));
    for (const Entry& entry : *entries) {
      const auto* table = entry.value.template as<Value::Table>();
      if (!table) {
        context_.parts_unread = true;
        context_.error(entry.value, fmt::format("{} '{}' must be a table, not {}", noun_, entry.key,
                                                entry.value.type_name()));
      }
      add(entry, table ? read(entry, *table) : std::nullopt);
    }
  }

 private:
  struct Thing {
    const Entry* entry;
    std::optional<Id> id;
    bool used;
  };

  // What a misspelt name probably meant is not called unused as well.
  void take_as_used(const std::string& name) {
    for (Thing& thing : things_) thing.used |= thing.entry->key == name;
  }

  const Context& context_;
  const char* noun_;
  std::vector<Thing> things_;
};

}  // namespace umbral::toml_file
