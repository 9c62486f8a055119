// Answers to what is asked of a directive's parameters.
#include "formats/pbrt/parameters.h"

#include <algorithm>

#include <fmt/format.h>

#include "core/names.h"

namespace umbral::pbrt_file {

const Parameter* Parameters::find(const std::string& name) const {
  if (std::find(asked_.begin(), asked_.end(), name) == asked_.end()) asked_.push_back(name);
  const auto found =
      std::find_if(list_.begin(), list_.end(), [&](const Parameter& p) { return p.name == name; });
  return found == list_.end() ? nullptr : &*found;
}

const Parameter* Parameters::find(const std::string& name, std::initializer_list<const char*> types,
                                  std::size_t count) const {
  const Parameter* found = find(name);
  if (!found) return nullptr;
  if (std::find(types.begin(), types.end(), found->type) == types.end()) {
    error(*found, fmt::format("'{}' must be \"{} {}\", not \"{} {}\"", name, *types.begin(), name,
                              found->type, name));
    return nullptr;
  }
  const std::size_t given = std::max(found->numbers.size(), found->strings.size());
  if (given == 0 || (count > 0 && given != count)) {
    error(*found, fmt::format("'{}' wants {} value{}, not {}", name, std::max<std::size_t>(count, 1),
                              count > 1 ? "s" : "", given));
    return nullptr;
  }
  return found;
}

double Parameters::number(const std::string& name, double otherwise) const {
  const Parameter* found = find(name, {"float"}, 1);
  return found ? found->numbers[0] : otherwise;
}

int Parameters::integer(const std::string& name, int otherwise) const {
  const Parameter* found = find(name, {"integer"}, 1);
  if (!found) return otherwise;
  const double value = found->numbers[0];
  if (value == std::floor(value) && std::abs(value) <= 2147483647.0) return static_cast<int>(value);
  error(*found, fmt::format("'{}' must be a whole number, not {}", name, value));
  return otherwise;
}

bool Parameters::flag(const std::string& name, bool otherwise) const {
  const Parameter* found = find(name, {"bool"}, 1);
  if (!found) return otherwise;
  if (found->strings[0] == "true" || found->strings[0] == "false") return found->strings[0] == "true";
  error(*found, fmt::format("'{}' must be true or false, not '{}'", name, found->strings[0]));
  return otherwise;
}

std::string Parameters::text(const std::string& name, const std::string& otherwise) const {
  const Parameter* found = find(name, {"string"}, 1);
  return found ? found->strings[0] : otherwise;
}

Vec3d Parameters::point(const std::string& name, const Vec3d& otherwise) const {
  const Parameter* found = find(name, {"point3", "point", "vector3", "vector", "normal3", "normal"}, 3);
  return found ? Vec3d(found->numbers[0], found->numbers[1], found->numbers[2]) : otherwise;
}

std::vector<double> Parameters::numbers(const std::string& name, std::initializer_list<const char*> types,
                                        std::size_t arity) const {
  const Parameter* found = find(name, types, 0);
  if (!found) return {};
  if (found->numbers.size() % arity == 0) return found->numbers;
  error(*found,
        fmt::format("'{}' has {} numbers, which is no multiple of {}", name, found->numbers.size(), arity));
  return {};
}

void Parameters::add_defaults(const Parameters& defaults) {
  for (const Parameter& parameter : defaults.list_) {
    const bool given = std::any_of(list_.begin(), list_.end(),
                                   [&](const Parameter& own) { return own.name == parameter.name; });
    if (!given) list_.push_back(parameter);
    if (!given) list_.back().inherited = true;
  }
}

void Parameters::ignore(std::initializer_list<const char*> names) const {
  for (const char* name : names) find(name);
}

void Parameters::lacks(const std::string& name, const std::string& what) const {
  if (const Parameter* found = find(name)) builder_->lacks(found->place, what);
}

void Parameters::approximates(const std::string& name, const std::string& what) const {
  if (const Parameter* found = find(name)) builder_->approximates(found->place, what);
}

void Parameters::error(const Parameter& at, std::string message) const {
  builder_->diagnostics.error(at.place, std::move(message));
}

void Parameters::report_unknown(const std::string& of) const {
  for (const Parameter& parameter : list_)
    if (!parameter.inherited && std::find(asked_.begin(), asked_.end(), parameter.name) == asked_.end())
      error(parameter, fmt::format("{} has no parameter '{}'{}", of, parameter.name,
                                   suggestion(parameter.name, asked_)));
}

}  // namespace umbral::pbrt_file
