// Statement after statement of an OBJ file.
#include "formats/obj/obj_reader.h"

#include <algorithm>
#include <array>
#include <map>
#include <unordered_map>

#include <fmt/format.h>

namespace umbral {
namespace {

class ObjParser {
 public:
  ObjParser(std::string_view text, TextErrors& errors) : in_(text), errors_(errors) {
    file_.materials.push_back({"", errors.bare_place(0)});
  }

  ObjFile parse();

 private:
  enum class Element { position, uv, normal };

  // An index beyond what was defined up to its line.
  struct Forward {
    Element element;
    std::int64_t index;
    int line, column;
  };

  void statement();
  void read_vertex(std::string_view word);
  template <class Vector>
  bool read_numbers(Vector& vector, int wanted);
  void read_face();
  bool read_corner(ObjCorner& corner);
  bool read_index(Element element, std::int32_t& index);
  void use_material();
  void other_statement(std::string_view word);
  void check_forward_references();
  void report_skipped();
  std::int64_t count(Element element) const;
  Place here() { return errors_.place(in_, in_.position()); }

  TextCursor in_;
  TextErrors& errors_;
  ObjFile file_;
  std::uint32_t material_ = 0;
  std::unordered_map<std::string, std::uint32_t> material_numbers_{{"", 0}};
  std::vector<Forward> forward_;
  std::size_t extras_ = 0;  // vertices with more than three numbers
  int extras_line_ = 0;
  std::map<std::string, std::pair<std::size_t, int>> skipped_;  // how often, and the first line
};

std::int64_t ObjParser::count(Element element) const {
  switch (element) {
    case Element::position:
      return static_cast<std::int64_t>(file_.positions.size());
    case Element::uv:
      return static_cast<std::int64_t>(file_.uvs.size());
    case Element::normal:
      return static_cast<std::int64_t>(file_.normals.size());
  }
  return 0;
}

template <class Vector>
bool ObjParser::read_numbers(Vector& vector, int wanted) {
  for (int i = 0; i < Vector::length(); ++i) {
    double value = 0;
    if (!in_.number(value)) {
      if (i >= wanted && in_.at_line_end()) return true;
      errors_.error(here(), in_.at_line_end() ? fmt::format("{} numbers are needed here", wanted)
                                              : "this is not a number that can be computed with");
      return false;
    }
    vector[i] = static_cast<float>(value);
  }
  return true;
}

void ObjParser::read_vertex(std::string_view word) {
  if (word == "v") {
    Vec3 position{0};
    in_.at_line_end();
    const char* begin = in_.position();
    if (!read_numbers(position, 3)) return;
    if (!is_finite(position)) errors_.error(errors_.place(in_, begin), "the vertex is not finite");
    file_.positions.push_back(position);
    if (!in_.at_line_end() && ++extras_ == 1) extras_line_ = in_.line();
  } else if (word == "vt") {
    Vec2 uv{0};
    if (read_numbers(uv, 1)) file_.uvs.push_back(uv);
  } else {
    Vec3 normal{0};
    if (read_numbers(normal, 3)) file_.normals.push_back(normal);
  }
}

bool ObjParser::read_index(Element element, std::int32_t& index) {
  const char* begin = in_.position();
  const std::int64_t known = count(element);
  static constexpr std::array names{"vertex", "texture coordinate", "normal"};
  const auto* name = names[static_cast<std::size_t>(element)];
  std::int64_t number = 0;
  if (!in_.integer(number)) {
    errors_.error(errors_.place(in_, begin), fmt::format("this is not the number of a {}", name));
    return false;
  }
  if (number == 0 || number < -known || number > std::numeric_limits<std::int32_t>::max()) {
    errors_.error(errors_.place(in_, begin),
                  number == 0 ? "numbers start from 1" : fmt::format("there is no {} {}", name, number));
    return false;
  }
  if (number > known) forward_.push_back({element, number, in_.line(), in_.column(begin)});
  index = static_cast<std::int32_t>(number > 0 ? number - 1 : known + number);
  return true;
}

// v, v/vt, v//vn or v/vt/vn.
bool ObjParser::read_corner(ObjCorner& corner) {
  corner = {-1, -1, -1};
  if (!read_index(Element::position, corner.position)) return false;
  if (in_.skip('/')) {
    const bool has_uv = !in_.at_word_end() && *in_.position() != '/';
    if (has_uv && !read_index(Element::uv, corner.uv)) return false;
    if (in_.skip('/') && !in_.at_word_end() && !read_index(Element::normal, corner.normal)) return false;
  }
  if (in_.at_word_end()) return true;
  errors_.error(here(), "a corner of a face is written v, v/vt, v//vn or v/vt/vn");
  return false;
}

void ObjParser::read_face() {
  const int line = in_.line();
  const std::size_t begin = file_.corners.size();
  ObjCorner corner{};
  while (!in_.at_line_end()) {
    if (!read_corner(corner)) {
      file_.corners.resize(begin);
      return;
    }
    file_.corners.push_back(corner);
  }
  if (file_.corners.size() - begin < 3) {
    file_.corners.resize(begin);
    other_statement("faces of fewer than 3 corners");
    return;
  }
  file_.faces.push_back({static_cast<std::uint32_t>(file_.corners.size()), material_, line});
}

void ObjParser::use_material() {
  in_.at_line_end();
  const Place place = here();
  const std::string name(in_.rest_of_line());
  const auto [entry, is_new] =
      material_numbers_.try_emplace(name, static_cast<std::uint32_t>(file_.materials.size()));
  if (is_new) file_.materials.push_back({name, place});
  material_ = entry->second;
}

void ObjParser::other_statement(std::string_view word) {
  auto& [number, line] = skipped_[std::string(word.substr(0, 40))];
  if (++number == 1) line = in_.line();
}

void ObjParser::statement() {
  static constexpr std::array ignored{"g",        "o",        "s",   "mg",         "bevel",
                                      "c_interp", "d_interp", "lod", "shadow_obj", "trace_obj"};
  const std::string_view word = in_.word();
  if (word == "v" || word == "vt" || word == "vn") {
    read_vertex(word);
  } else if (word == "f" || word == "fo") {
    read_face();
  } else if (word == "usemtl") {
    use_material();
  } else if (word == "mtllib") {
    in_.at_line_end();
    const Place place = here();
    file_.libraries.push_back({std::string(in_.rest_of_line()), place});
  } else if (std::find(ignored.begin(), ignored.end(), word) == ignored.end()) {
    other_statement(word == "l" ? "lines" : word == "p" ? "points" : fmt::format("'{}' statements", word));
  }
}

void ObjParser::check_forward_references() {
  for (const Forward& forward : forward_) {
    const std::int64_t known = count(forward.element);
    if (forward.index <= known) continue;
    static constexpr std::array names{"vertices", "texture coordinates", "normals"};
    errors_.error(errors_.place(forward.line, forward.column),
                  fmt::format("there is no number {}: the file has {} {}", forward.index, known,
                              names[static_cast<std::size_t>(forward.element)]));
  }
}

void ObjParser::report_skipped() {
  for (const auto& [what, found] : skipped_)
    errors_.warning(errors_.bare_place(found.second), fmt::format("not used: {} {}", found.first, what));
  if (extras_ > 0)
    errors_.warning(errors_.bare_place(extras_line_),
                    fmt::format("not used: the colours or weights of {} vertices", extras_));
}

ObjFile ObjParser::parse() {
  while (!in_.at_end() && !errors_.full()) {
    if (!in_.at_line_end()) statement();
    in_.next_line();
  }
  check_forward_references();
  report_skipped();
  return std::move(file_);
}

}  // namespace

ObjFile parse_obj(std::string_view text, TextErrors& errors) { return ObjParser(text, errors).parse(); }

}  // namespace umbral
