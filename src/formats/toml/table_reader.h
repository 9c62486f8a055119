// TableReader: hands out the values of a table by name and afterwards tells which keys nobody asked for.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "formats/input/diagnostics.h"
#include "formats/toml/document.h"

namespace umbral::toml_file {

// Where a document's messages go.
struct Context {
  Diagnostics& diagnostics;
  std::shared_ptr<const SourceText> source;
  mutable bool parts_unread = false;  // some table was so wrong that what it uses is not known

  Place place(int line, int column) const { return {{source->name(), line, column}, source}; }
  Place place(const Value& value) const { return place(value.line, value.column); }
  Place place(const Entry& entry) const { return place(entry.line, entry.column); }

  template <class Located>
  void error(const Located& at, std::string message) const {
    diagnostics.error(place(at), std::move(message));
  }
};

class TableReader {
 public:
  // `owner` is what messages call the table; `place` is where they say that something lacks. A table that the
  // file does not have is null: it is empty.
  TableReader(const Context& context, const Value::Table* table, std::string owner, Place place);

  const Context& context() const { return context_; }
  const std::string& owner() const { return owner_; }
  void rename(std::string owner) { owner_ = std::move(owner); }
  const Place& place() const { return place_; }

  // The value of that key, which is known from now on; null if the table has none.
  const Value* find(std::string_view key);
  const Entry* find_entry(std::string_view key);

  // The same, of that type alone; a value of another type is an error.
  template <class T>
  const T* find_as(std::string_view key, const char* wanted) {
    const Value* value = find(key);
    if (!value) return nullptr;
    const T* typed = value->as<T>();
    if (!typed) wrong_type(key, *value, wanted);
    return typed;
  }

  // find_as() a string that is one of `choices`, or else an error: "'spere' is not a shape; did you mean …".
  std::optional<std::string> find_kind(const char* noun, const std::vector<std::string>& choices);

  bool has(std::string_view key) const;
  void missing(std::string_view key) const;
  void wrong_type(std::string_view key, const Value& value, const std::string& wanted) const;

  // Tells every key that was never asked for: "'x' is not a parameter of 'owner'; did you mean …".
  void finish(const char* noun = "parameter") const;

 private:
  const Context& context_;
  const Value::Table* table_;
  std::string owner_;
  Place place_;
  std::vector<std::string> known_;
  std::vector<bool> used_;
};

// Calls read(table, entry or item) for every table in a list of tables; anything else is an error.
void for_each_table(const Context& context, const Value& list, const std::string& key,
                    const std::function<void(const Value& item, const Value::Table& table)>& read);

}  // namespace umbral::toml_file
