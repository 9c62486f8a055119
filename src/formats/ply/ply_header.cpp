// Statement after statement of a PLY header.
#include "formats/ply/ply_header.h"

#include <algorithm>
#include <array>
#include <limits>

#include <fmt/format.h>

namespace umbral {
namespace {

// Both generations of type names, in the order of PlyType.
constexpr std::array<std::array<const char*, 2>, 8> type_names{{{"char", "int8"},
                                                                {"uchar", "uint8"},
                                                                {"short", "int16"},
                                                                {"ushort", "uint16"},
                                                                {"int", "int32"},
                                                                {"uint", "uint32"},
                                                                {"float", "float32"},
                                                                {"double", "float64"}}};

class HeaderParser {
 public:
  HeaderParser(TextCursor& in, const std::shared_ptr<const SourceText>& source) : in_(in), source_(source) {}

  PlyHeader parse();

 private:
  [[noreturn]] void fail(const char* at, std::string message) const {
    throw_at(source_, in_.line(), in_.column(at), std::move(message));
  }
  std::string_view word() {
    const std::string_view found = in_.word();
    if (found.empty()) fail(in_.position(), "something is missing at the end of this line");
    return found;
  }
  void read_format();
  void read_element();
  void read_property();
  PlyType read_type();
  void check_size() const;

  TextCursor& in_;
  const std::shared_ptr<const SourceText>& source_;
  PlyHeader header_;
};

void HeaderParser::read_format() {
  static constexpr std::array names{"ascii", "binary_little_endian", "binary_big_endian"};
  const std::string_view name = word();
  const auto found = std::find(names.begin(), names.end(), name);
  if (found == names.end()) fail(name.data(), fmt::format("'{}' is not a PLY format", name));
  header_.format = static_cast<PlyFormat>(found - names.begin());
}

void HeaderParser::read_element() {
  const std::string name(word());
  std::int64_t count = 0;
  const bool good = in_.integer(count) && in_.at_word_end() && count >= 0;
  if (!good) fail(in_.position(), "this is not a number of elements");
  header_.elements.push_back({name, static_cast<std::uint64_t>(count), {}});
}

PlyType HeaderParser::read_type() {
  const std::string_view name = word();
  for (std::size_t i = 0; i < type_names.size(); ++i)
    if (name == type_names[i][0] || name == type_names[i][1]) return static_cast<PlyType>(i);
  fail(name.data(), fmt::format("'{}' is not a PLY type", name));
}

void HeaderParser::read_property() {
  const bool empty = in_.at_line_end();
  if (header_.elements.empty()) fail(in_.position(), "a property comes before any element");
  PlyProperty property{};
  if (!empty && *in_.position() == 'l') {
    word();
    property.is_list = true;
    in_.at_line_end();
    const char* at = in_.position();
    property.count_type = read_type();
    if (property.count_type >= PlyType::float32) fail(at, "the length of a list must be a whole number");
  }
  property.type = read_type();
  property.name = word();
  header_.elements.back().properties.push_back(std::move(property));
}

// Every element takes some bytes, so that no file of a few bytes makes anyone allocate for millions.
void HeaderParser::check_size() const {
  const std::string_view text = source_->text();
  const auto left = static_cast<std::uint64_t>(text.data() + text.size() - in_.position());
  for (const PlyElement& element : header_.elements) {
    std::uint64_t bytes = 0;
    for (const PlyProperty& property : element.properties) {
      const bool ascii = header_.format == PlyFormat::ascii;
      bytes += ascii ? 2 : size_of(property.is_list ? property.count_type : property.type);
    }
    const std::uint64_t most = bytes == 0 ? std::numeric_limits<std::uint64_t>::max() : (left + 1) / bytes;
    if (element.count > most)
      throw_at(
          source_, 0, 0,
          fmt::format(
              "the header promises {} elements '{}', but the {} bytes behind it cannot hold more than {}",
              element.count, element.name, left, most));
  }
}

PlyHeader HeaderParser::parse() {
  if (in_.word() != "ply") throw_at(source_, 1, 0, "this is not a PLY file: it does not begin with 'ply'");
  in_.next_line();
  while (true) {
    if (in_.at_end()) throw_at(source_, 0, 0, "the header does not end: 'end_header' is missing");
    const std::string_view key = in_.word();
    if (key == "format") {
      read_format();
    } else if (key == "element") {
      read_element();
    } else if (key == "property") {
      read_property();
    } else if (key != "comment" && key != "obj_info" && key != "end_header" && !key.empty()) {
      fail(key.data(), "this is not a statement of a PLY header");
    }
    in_.next_line();
    if (key == "end_header") break;
  }
  check_size();
  return std::move(header_);
}

}  // namespace

std::size_t size_of(PlyType type) {
  static constexpr std::array<std::size_t, 8> sizes{1, 1, 2, 2, 4, 4, 4, 8};
  return sizes[static_cast<std::size_t>(type)];
}

std::optional<std::size_t> PlyElement::find(std::string_view property) const {
  for (std::size_t i = 0; i < properties.size(); ++i)
    if (properties[i].name == property) return i;
  return std::nullopt;
}

void throw_at(const std::shared_ptr<const SourceText>& source, int line, int column, std::string message) {
  const Place place{{source->name(), line, column}, source};
  throw SceneError({{Severity::error, place.where, std::move(message), place.excerpt()}});
}

PlyHeader parse_ply_header(TextCursor& in, const std::shared_ptr<const SourceText>& source) {
  return HeaderParser(in, source).parse();
}

}  // namespace umbral
