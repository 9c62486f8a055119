// Answers to what is asked of an object's properties.
#include "formats/mitsuba/properties.h"

#include <charconv>

#include <fmt/format.h>

#include "core/names.h"

namespace umbral::mitsuba_file {
namespace {

std::string attribute(const Element& element, const std::string& name) {
  const auto found = element.attributes.find(name);
  return found == element.attributes.end() ? std::string() : found->second;
}

bool is_blank(char c) { return c == ' ' || c == ',' || c == '\t' || c == '\n' || c == '\r'; }

}  // namespace

std::vector<double> numbers_in(const std::string& text) {
  std::vector<double> numbers;
  const char *p = text.data(), *const end = p + text.size();
  while (true) {
    while (p != end && is_blank(*p)) ++p;
    if (p == end) return numbers;
    double value = 0;
    const auto [next, failure] = std::from_chars(*p == '+' ? p + 1 : p, end, value);
    if (failure != std::errc() || !std::isfinite(value) || (next != end && !is_blank(*next))) return {};
    numbers.push_back(value);
    p = next;
  }
}

const Element* Properties::followed(const Element& element) const {
  used_.insert(&element);
  if (element.tag != "ref") return &element;
  const auto found = document_.by_id.find(element.id);
  if (found != document_.by_id.end()) return found->second;
  std::vector<std::string> ids;
  for (const auto& [id, ignored] : document_.by_id) ids.push_back(id);
  error(element.place,
        fmt::format("there is nothing with the id '{}'{}", element.id, suggestion(element.id, ids)));
  return nullptr;
}

const Element* Properties::find(const std::string& name) const {
  asked_.insert(name);
  for (const Element& child : element_.children)
    if (child.name == name) return followed(child);
  return nullptr;
}

std::vector<const Element*> Properties::objects(const std::string& tag) const {
  std::vector<const Element*> found;
  for (const Element& child : element_.children) {
    if (child.tag == tag) {
      used_.insert(&child);
      found.push_back(&child);
    } else if (child.tag == "ref") {
      const auto target = document_.by_id.find(child.id);
      if (target == document_.by_id.end())
        followed(child);  // tells of it
      else if (target->second->tag == tag)
        found.push_back(followed(child));
    }
  }
  return found;
}

const Element* Properties::object(const std::string& tag) const {
  const std::vector<const Element*> all = objects(tag);
  return all.empty() ? nullptr : all.front();
}

const Element* Properties::find(const std::string& name, std::initializer_list<const char*> tags) const {
  const Element* found = find(name);
  if (!found) return nullptr;
  for (const char* tag : tags)
    if (found->tag == tag) return found;
  error(found->place, fmt::format("'{}' of '{}' must be a <{}>, not a <{}>", name, element_.type,
                                  *tags.begin(), found->tag));
  return nullptr;
}

double Properties::number(const std::string& name, double otherwise) const {
  const Element* found = find(name, {"float", "integer"});
  if (!found) return otherwise;
  const std::vector<double> values = numbers_in(attribute(*found, "value"));
  if (values.size() == 1) return values[0];
  error(found->place, fmt::format("'{}' must be a number, not '{}'", name, attribute(*found, "value")));
  return otherwise;
}

int Properties::integer(const std::string& name, int otherwise) const {
  const Element* found = find(name, {"integer"});
  if (!found) return otherwise;
  const std::vector<double> values = numbers_in(attribute(*found, "value"));
  if (values.size() == 1 && values[0] == std::floor(values[0]) && std::abs(values[0]) <= 2147483647.0)
    return static_cast<int>(values[0]);
  error(found->place, fmt::format("'{}' must be a whole number, not '{}'", name, attribute(*found, "value")));
  return otherwise;
}

bool Properties::flag(const std::string& name, bool otherwise) const {
  const Element* found = find(name, {"boolean"});
  if (!found) return otherwise;
  const std::string value = attribute(*found, "value");
  if (value == "true" || value == "false") return value == "true";
  error(found->place, fmt::format("'{}' must be true or false, not '{}'", name, value));
  return otherwise;
}

std::string Properties::text(const std::string& name, const std::string& otherwise) const {
  const Element* found = find(name, {"string"});
  return found ? attribute(*found, "value") : otherwise;
}

namespace {

// "x y z", one number for all three where `spread` is set, or the attributes x, y and z, of which those that lack are
// `otherwise`.
std::optional<Vec3d> vector_of(const Element& element, bool spread, double otherwise) {
  if (element.attributes.contains("value")) {
    const std::vector<double> v = numbers_in(attribute(element, "value"));
    if (v.size() == 3) return Vec3d(v[0], v[1], v[2]);
    if (v.size() == 1 && spread) return Vec3d(v[0]);
    return std::nullopt;
  }
  Vec3d result(otherwise);
  for (int i = 0; i < 3; ++i) {
    const std::string text = attribute(element, std::string(1, "xyz"[i]));
    if (text.empty()) continue;
    const std::vector<double> v = numbers_in(text);
    if (v.size() != 1) return std::nullopt;
    result[i] = v[0];
  }
  return result;
}

std::optional<Vec3d> vector_in(const Element& element, const char* name) {
  const std::vector<double> v = numbers_in(attribute(element, name));
  if (v.size() != 3) return std::nullopt;
  return Vec3d(v[0], v[1], v[2]);
}

std::optional<Affine> rotation_of(const Element& element) {
  const std::vector<double> angle = numbers_in(attribute(element, "angle"));
  const auto axis = vector_of(element, false, 0);
  if (angle.size() != 1 || !axis || !(glm::length(*axis) > 0)) return std::nullopt;
  return rotation(glm::normalize(*axis), glm::radians(angle[0]));
}

// Columns: x to the left of a viewer, y up, z along the view.
std::optional<Affine> look_at_of(const Element& element) {
  const auto origin = vector_in(element, "origin"), target = vector_in(element, "target");
  if (!origin || !target) return std::nullopt;
  const Vec3d view = *target - *origin;
  Vec3d up = vector_in(element, "up").value_or(Vec3d(0));
  if (!(glm::length(up) > 0))
    up = std::abs(view.z) < 0.99 * glm::length(view) ? Vec3d(0, 0, 1) : Vec3d(0, 1, 0);
  const Vec3d left = cross(up, view);
  if (!(glm::length(view) > 0) || !(glm::length(left) > 1e-9 * glm::length(view) * glm::length(up)))
    return std::nullopt;
  const Vec3d z = glm::normalize(view), x = glm::normalize(left);
  return Affine{glm::dmat3(x, cross(z, x), z), *origin};
}

std::optional<Affine> matrix_of(const Element& element) {
  const std::vector<double> m = numbers_in(attribute(element, "value"));
  Affine map;
  if (m.size() == 9) {
    for (int row = 0; row < 3; ++row)
      for (int column = 0; column < 3; ++column)
        map.linear[column][row] = m[static_cast<std::size_t>(3 * row + column)];
    return map;
  }
  if (m.size() != 16 || m[12] != 0 || m[13] != 0 || m[14] != 0 || m[15] != 1) return std::nullopt;
  for (int row = 0; row < 3; ++row) {
    for (int column = 0; column < 3; ++column)
      map.linear[column][row] = m[static_cast<std::size_t>(4 * row + column)];
    map.offset[row] = m[static_cast<std::size_t>(4 * row + 3)];
  }
  return map;
}

std::optional<Affine> operation(const Element& element) {
  if (element.tag == "translate") {
    const auto offset = vector_of(element, false, 0);
    if (offset) return translation(*offset);
  } else if (element.tag == "scale") {
    const auto factors = vector_of(element, true, 1);
    if (factors) return scaling(*factors);
  } else if (element.tag == "rotate") {
    return rotation_of(element);
  } else if (element.tag == "lookat") {
    return look_at_of(element);
  } else if (element.tag == "matrix") {
    return matrix_of(element);
  }
  return std::nullopt;
}

}  // namespace

std::optional<Affine> transform_of(SceneBuilder& builder, const Element& element) {
  Affine map;
  for (const Element& child : element.children) {
    const std::optional<Affine> next = operation(child);
    if (!next) {
      builder.diagnostics.error(child.place,
                                fmt::format("<{}> is no transform that can be understood", child.tag));
      return std::nullopt;
    }
    map = *next * map;
  }
  const double volume = map.determinant();
  if (volume != 0 && std::isfinite(1 / volume)) return map;
  builder.diagnostics.error(element.place, "this transform flattens everything: its determinant is 0");
  return std::nullopt;
}

Vec3d Properties::vector(const std::string& name, const Vec3d& otherwise) const {
  const Element* found = find(name, {"point", "vector"});
  if (!found) return otherwise;
  if (const auto value = vector_of(*found, false, 0)) return *value;
  error(found->place, fmt::format("'{}' must be three numbers", name));
  return otherwise;
}

Affine Properties::transform(const std::string& name) const {
  const Element* found = find(name, {"transform"});
  return found ? transform_of(builder_, *found).value_or(Affine{}) : Affine{};
}

void Properties::ignore(std::initializer_list<const char*> names) const {
  for (const char* name : names) find(name);
}

void Properties::lacks(const std::string& name, const std::string& what) const {
  if (const Element* found = find(name)) builder_.lacks(found->place, what);
}

void Properties::report_unknown() const {
  for (const Element& child : element_.children) {
    if (used_.contains(&child)) continue;
    const std::string name = child.name.empty() ? child.tag : child.name;
    error(child.place, fmt::format("'{}' has no property '{}'{}", element_.type, name,
                                   suggestion(name, {asked_.begin(), asked_.end()})));
  }
}

}  // namespace umbral::mitsuba_file
