// Look-up of keys and what is said of those that are missing, wrong or unknown.
#include "formats/toml/table_reader.h"

#include <algorithm>

#include <fmt/format.h>

#include "core/names.h"

namespace umbral::toml_file {
namespace {

const char* article(std::string_view noun) {
  return std::string_view("aeiou").find(noun[0]) != std::string_view::npos ? "an" : "a";
}

}  // namespace

TableReader::TableReader(const Context& context, const Value::Table* table, std::string owner, Place place)
    : context_(context),
      table_(table),
      owner_(std::move(owner)),
      place_(std::move(place)),
      used_(table ? table->size() : 0, false) {}

const Entry* TableReader::find_entry(std::string_view key) {
  if (std::find(known_.begin(), known_.end(), key) == known_.end()) known_.emplace_back(key);
  for (std::size_t i = 0; i < used_.size(); ++i) {
    if ((*table_)[i].key != key) continue;
    used_[i] = true;
    return &(*table_)[i];
  }
  return nullptr;
}

const Value* TableReader::find(std::string_view key) {
  const Entry* entry = find_entry(key);
  return entry ? &entry->value : nullptr;
}

bool TableReader::has(std::string_view key) const {
  return table_ &&
         std::any_of(table_->begin(), table_->end(), [&](const Entry& entry) { return entry.key == key; });
}

void TableReader::missing(std::string_view key) const {
  context_.diagnostics.error(place_, fmt::format("'{}' of '{}' is missing", key, owner_));
}

void TableReader::wrong_type(std::string_view key, const Value& value, const std::string& wanted) const {
  context_.error(value,
                 fmt::format("'{}' of '{}' must be {}, not {}", key, owner_, wanted, value.type_name()));
}

std::optional<std::string> TableReader::find_kind(const char* noun, const std::vector<std::string>& choices) {
  const std::string* kind = find_as<std::string>("type", "a string");
  if (kind && std::find(choices.begin(), choices.end(), *kind) != choices.end()) return *kind;
  context_.parts_unread = true;
  if (!has("type"))
    context_.diagnostics.error(place_,
                               fmt::format("'type' of the {} is missing{}", noun, suggestion("", choices)));
  if (kind)
    context_.error(*find("type"), fmt::format("'{}' is not {} {}{}", *kind, article(noun), noun,
                                              suggestion(*kind, choices)));
  return std::nullopt;
}

void TableReader::finish(const char* noun) const {
  for (std::size_t i = 0; i < used_.size(); ++i) {
    if (used_[i]) continue;
    const Entry& entry = (*table_)[i];
    context_.error(entry, fmt::format("'{}' is not a {} of '{}'{}", entry.key, noun, owner_,
                                      suggestion(entry.key, known_)));
  }
}

void for_each_table(const Context& context, const Value& list, const std::string& key,
                    const std::function<void(const Value&, const Value::Table&)>& read) {
  const auto* items = list.as<Value::Array>();
  if (!items) {
    context.error(
        list, fmt::format("'{0}' must be a list of tables (write [[{0}]]), not {1}", key, list.type_name()));
    return;
  }
  for (const Value& item : *items) {
    if (const auto* table = item.as<Value::Table>())
      read(item, *table);
    else
      context.error(item, fmt::format("'{}' must be a list of tables, but holds {}", key, item.type_name()));
  }
}

}  // namespace umbral::toml_file
