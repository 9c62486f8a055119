// NameTable: the named things of one section, and which of them were used.
#pragma once

#include <algorithm>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "core/names.h"
#include "formats/toml/table_reader.h"

namespace umbral::toml_file {

// Things are read in the order in which they stand, but for those that others ask for before: what is made from
// others may stand anywhere.
template <class Id>
class NameTable {
 public:
  // `noun` is what messages call a thing: "texture".
  NameTable(const Context& context, const char* noun) : context_(context), noun_(noun) {}

  // Makes the tables of the section known; anything else in it is an error. read(entry, table) is called for each, once:
  // when it is first asked for, or by read_rest().
  template <class Read>
  void open_section(const Value& section, Read&& read) {
    read_ = std::forward<Read>(read);
    const auto* entries = section.as<Value::Table>();
    if (!entries) return context_.error(section, fmt::format("write {0}s as [{0}s.NAME]", noun_));
    for (const Entry& entry : *entries) {
      const auto* table = entry.value.template as<Value::Table>();
      things_.push_back({&entry, table, std::nullopt, false, table ? State::unread : State::read});
      if (table) continue;
      context_.parts_unread = true;
      context_.error(entry.value, fmt::format("{} '{}' must be a table, not {}", noun_, entry.key,
                                              entry.value.type_name()));
    }
  }

  void read_rest() {
    for (std::size_t i = 0; i < things_.size(); ++i)
      if (things_[i].state == State::unread) read_thing(i);
  }

  template <class Read>
  void read_section(const Value& section, Read&& read) {
    open_section(section, std::forward<Read>(read));
    read_rest();
  }

  // What `value` names; none, and told, where there is no such thing, where it is broken, or where it is asked for
  // while it is being read: then it is made from itself.
  std::optional<Id> find(const Value& value) {
    const auto* name = value.as<std::string>();
    if (!name) {
      context_.error(value,
                     fmt::format("the name of a {} must be a string, not {}", noun_, value.type_name()));
      return std::nullopt;
    }
    for (std::size_t i = 0; i < things_.size(); ++i) {
      if (things_[i].entry->key != *name) continue;
      things_[i].used = true;
      if (things_[i].state == State::being_read) {
        report_ring(value, i);
        return std::nullopt;
      }
      if (things_[i].state == State::unread) read_thing(i);
      return things_[i].id;
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

 private:
  enum class State { unread, being_read, read };
  struct Thing {
    const Entry* entry;
    const Value::Table* table;
    std::optional<Id> id;
    bool used;
    State state;
  };

  void read_thing(std::size_t i) {
    things_[i].state = State::being_read;
    chain_.push_back(i);
    things_[i].id = read_(*things_[i].entry, *things_[i].table);
    chain_.pop_back();
    things_[i].state = State::read;
  }

  void report_ring(const Value& value, std::size_t first) const {
    std::string ring;
    const auto begin = std::find(chain_.begin(), chain_.end(), first);
    for (auto link = begin; link != chain_.end(); ++link)
      ring += fmt::format("'{}' is made from ", things_[*link].entry->key);
    const std::string& name = things_[first].entry->key;
    context_.error(value, fmt::format("{} '{}' is made from itself: {}'{}'", noun_, name, ring, name));
  }

  // What a misspelt name probably meant is not called unused as well.
  void take_as_used(const std::string& name) {
    for (Thing& thing : things_) thing.used |= thing.entry->key == name;
  }

  const Context& context_;
  const char* noun_;
  std::vector<Thing> things_;
  std::vector<std::size_t> chain_;  // what is being read, from the outermost
  std::function<std::optional<Id>(const Entry&, const Value::Table&)> read_;
};

}  // namespace umbral::toml_file
