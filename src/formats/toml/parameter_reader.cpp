// Values of each type out of a document, checked against the type and range of their parameter.
#include "formats/toml/parameter_reader.h"

#include <charconv>

#include <fmt/format.h>

#include "core/names.h"
#include "formats/toml/texture_library.h"

namespace umbral::toml_file {

std::string range_text(const Range& range) {
  const bool low = range.low > -infinity, high = range.high < infinity;
  if (low && high && !range.low_open && !range.high_open)
    return fmt::format("between {} and {}", range.low, range.high);
  const std::string from = fmt::format("{} {}", range.low_open ? "above" : "at least", range.low);
  const std::string to = fmt::format("{} {}", range.high_open ? "below" : "at most", range.high);
  if (low && high) return from + " and " + to;
  if (low) return from;
  return high ? to : "finite";
}

const Value* ParameterReader::find(const ParameterInfo& info) {
  const Value* value = table_.find(info.name);
  if (!value && info.required) table_.missing(info.name);
  return value;
}

void ParameterReader::wrong_number(const ParameterInfo& info, const Value& value, double number,
                                   const std::string& wanted) const {
  table_.context().error(
      value, fmt::format("'{}' of '{}' is {} but must be {}", info.name, table_.owner(), number, wanted));
}

bool ParameterReader::read_number(const ParameterInfo& info, const Value& value, float& number) {
  const std::optional<double> read = value.number();
  if (!read) {
    table_.wrong_type(info.name, value, "a number");
    return false;
  }
  const auto rounded = static_cast<float>(*read);
  if (!info.range.contains(rounded)) {
    wrong_number(info, value, *read, range_text(info.range));
    return false;
  }
  number = rounded;
  return true;
}

template <int N>
bool ParameterReader::read_numbers(const ParameterInfo& info, const Value& value,
                                   glm::vec<N, float>& numbers) {
  const auto* items = value.as<Value::Array>();
  if (!items || items->size() != N) {
    const std::string wanted = fmt::format("a list of {} numbers", N);
    if (!items)
      table_.wrong_type(info.name, value, wanted);
    else
      table_.context().error(value, fmt::format("'{}' of '{}' must be {}, not of {}", info.name,
                                                table_.owner(), wanted, items->size()));
    return false;
  }
  glm::vec<N, float> read(0.0f);
  bool good = true;
  for (int i = 0; i < N; ++i) {
    const Value& item = (*items)[static_cast<std::size_t>(i)];
    if (item.number()) {
      good &= read_number(info, item, read[i]);
    } else {
      table_.context().error(item, fmt::format("'{}' of '{}' must hold numbers, not {}", info.name,
                                               table_.owner(), item.type_name()));
      good = false;
    }
  }
  if (good) numbers = read;
  return good;
}

bool ParameterReader::read_hex_color(const ParameterInfo& info, const Value& value, const std::string& text,
                                     Spectrum& color) {
  unsigned code = 0;
  const char* end = text.data() + text.size();
  const auto parsed = std::from_chars(text.data() + 1, end, code, 16);
  if (text.size() != 7 || parsed.ec != std::errc() || parsed.ptr != end) {
    table_.context().error(value, fmt::format("'{}' of '{}': '{}' is not a colour of the form '#rrggbb'",
                                              info.name, table_.owner(), text));
    return false;
  }
  const auto channel = [&](unsigned shift) {
    return srgb_decode(static_cast<float>((code >> shift) & 255) / 255);
  };
  color = rgb(channel(16), channel(8), channel(0));
  return true;
}

bool ParameterReader::read_color(const ParameterInfo& info, const Value& value, Spectrum& color) {
  if (value.number()) {
    float number = 0;
    if (!read_number(info, value, number)) return false;
    color = grey(number);
    return true;
  }
  const auto* text = value.as<std::string>();
  if (text && text->starts_with('#')) return read_hex_color(info, value, *text, color);
  if (!value.as<Value::Array>()) {
    table_.wrong_type(info.name, value, "a colour ([r, g, b], one number or '#rrggbb')");
    return false;
  }
  Vec3 channels{0};
  if (!read_numbers(info, value, channels)) return false;
  color = rgb(channels.r, channels.g, channels.b);
  return true;
}

void ParameterReader::operator()(const ParameterInfo& info, bool& value) {
  if (const Value* found = find(info)) {
    if (const bool* read = found->as<bool>())
      value = *read;
    else
      table_.wrong_type(info.name, *found, "true or false");
  }
}

std::optional<std::int64_t> ParameterReader::integer(const ParameterInfo& info) {
  const Value* found = find(info);
  if (!found) return std::nullopt;
  const auto* read = found->as<std::int64_t>();
  if (!read) {
    if (const std::optional<double> number = found->number())
      wrong_number(info, *found, *number, "a whole number");
    else
      table_.wrong_type(info.name, *found, "a whole number");
    return std::nullopt;
  }
  if (info.range.contains(static_cast<double>(*read))) return *read;
  wrong_number(info, *found, static_cast<double>(*read), range_text(info.range));
  return std::nullopt;
}

void ParameterReader::operator()(const ParameterInfo& info, int& value) {
  ParameterInfo bounded = info;
  bounded.range.low = std::max(bounded.range.low, -2147483648.0f);
  bounded.range.high = std::min(bounded.range.high, 2147483520.0f);  // the largest float that an int can hold
  if (const auto read = integer(bounded)) value = static_cast<int>(*read);
}

void ParameterReader::operator()(const ParameterInfo& info, std::uint64_t& value) {
  ParameterInfo bounded = info;
  if (bounded.range.low < 0) bounded.range = {0, bounded.range.high, false, bounded.range.high_open};
  if (const auto read = integer(bounded)) value = static_cast<std::uint64_t>(*read);
}

void ParameterReader::operator()(const ParameterInfo& info, float& value) {
  if (const Value* found = find(info)) read_number(info, *found, value);
}

void ParameterReader::operator()(const ParameterInfo& info, Vec2& value) {
  if (const Value* found = find(info)) read_numbers(info, *found, value);
}

void ParameterReader::operator()(const ParameterInfo& info, Vec3& value) {
  if (const Value* found = find(info)) read_numbers(info, *found, value);
}

void ParameterReader::operator()(const ParameterInfo& info, Spectrum& value) {
  if (const Value* found = find(info)) read_color(info, *found, value);
}

void ParameterReader::operator()(const ParameterInfo& info, std::string& value) {
  const Value* found = find(info);
  if (!found) return;
  const auto* read = found->as<std::string>();
  if (!read)
    table_.wrong_type(info.name, *found, "a string");
  else if (read->empty())
    table_.context().error(*found, fmt::format("'{}' of '{}' is empty", info.name, table_.owner()));
  else
    value = *read;
}

bool ParameterReader::read_stop(const ParameterInfo& info, const Value& value, ColorStop& stop) {
  const auto* pair = value.as<Value::Array>();
  if (!pair || pair->size() != 2 || !(*pair)[0].number()) {
    table_.context().error(
        value, fmt::format("'{}' of '{}' must hold pairs [number, colour]", info.name, table_.owner()));
    return false;
  }
  const ParameterInfo of_color{info.name, info.doc, non_negative};
  return read_number(info, (*pair)[0], stop.at) && read_color(of_color, (*pair)[1], stop.color);
}

void ParameterReader::operator()(const ParameterInfo& info, ColorStops& value) {
  const Value* found = find(info);
  if (!found) return;
  const auto* items = found->as<Value::Array>();
  if (!items || items->empty())
    return table_.wrong_type(info.name, *found, "a list of pairs [number, colour]");
  ColorStops stops(items->size(), {0, black});
  bool good = true;
  for (std::size_t i = 0; i < stops.size(); ++i) good &= read_stop(info, (*items)[i], stops[i]);
  if (good) value = std::move(stops);
}

bool ParameterReader::names_texture(const Value& value) const {
  const auto* text = value.as<std::string>();
  return value.as<Value::Table>() || (text && !text->starts_with('#'));
}

template <class T>
void ParameterReader::read_texture(const ParameterInfo& info, const Value& value, Textured<T>& textured) {
  if (!textures_) return table_.wrong_type(info.name, value, "a constant");
  if (const auto id = textures_->find(value, info, std::is_same_v<T, Spectrum>)) textured.map = *id;
}

void ParameterReader::operator()(const ParameterInfo& info, Textured<float>& value) {
  const Value* found = find(info);
  if (!found) return;
  if (names_texture(*found))
    read_texture(info, *found, value);
  else
    read_number(info, *found, value.value);
}

void ParameterReader::operator()(const ParameterInfo& info, Textured<Spectrum>& value) {
  const Value* found = find(info);
  if (!found) return;
  if (names_texture(*found))
    read_texture(info, *found, value);
  else
    read_color(info, *found, value.value);
}

void ParameterReader::operator()(const ParameterInfo& info, MaterialId& value) {
  const Value* found = find(info);
  if (!found) return;
  if (!materials_) return table_.wrong_type(info.name, *found, "a constant");
  if (const auto id = materials_->find(*found)) value = *id;
}

void ParameterReader::choice(const ParameterInfo& info, int& index, std::span<const char* const> names) {
  const Value* found = find(info);
  if (!found) return;
  const auto* read = found->as<std::string>();
  if (!read) return table_.wrong_type(info.name, *found, "a string");
  for (std::size_t i = 0; i < names.size(); ++i)
    if (*read == names[i]) {
      index = static_cast<int>(i);
      return;
    }
  table_.context().error(*found, fmt::format("'{}' of '{}' cannot be '{}'{}", info.name, table_.owner(),
                                             *read, suggestion(*read, {names.begin(), names.end()})));
}

bool read_vector(const TableReader& table, std::string_view key, const Value& value, Vec3d& vector) {
  const auto* items = value.as<Value::Array>();
  bool good = items && items->size() == 3;
  Vec3d read{0};
  for (int i = 0; good && i < 3; ++i) {
    read[i] = (*items)[static_cast<std::size_t>(i)].number().value_or(std::nan(""));
    good = std::isfinite(read[i]);
  }
  if (good)
    vector = read;
  else if (items)
    table.context().error(value,
                          fmt::format("'{}' of '{}' must be a list of 3 finite numbers", key, table.owner()));
  else
    table.wrong_type(key, value, "a list of 3 numbers");
  return good;
}

}  // namespace umbral::toml_file
