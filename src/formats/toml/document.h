// A TOML document as a tree of values that know their place.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "formats/input/source_text.h"

namespace umbral::toml_file {

struct Entry;

struct DateOrTime {};

// A value of the document; line and column count from 1.
struct Value {
  using Array = std::vector<Value>;
  using Table = std::vector<Entry>;  // in the order of the file

  std::variant<bool, std::int64_t, double, std::string, Array, Table, DateOrTime> data;
  int line = 0, column = 0;

  template <class T>
  const T* as() const {
    return std::get_if<T>(&data);
  }

  // Of an integer or a floating-point number.
  std::optional<double> number() const;

  // "a string", "a number", "a list", …
  const char* type_name() const;
};

struct Entry {
  std::string key;
  int line = 0, column = 0;  // of the key
  Value value;
};

// The root table. Throws SceneError at the first mistake of syntax, repeated keys among them.
Value parse(const std::shared_ptr<const SourceText>& source);

}  // namespace umbral::toml_file
