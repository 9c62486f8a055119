// The kinds of a closed list (a variant of described structs), by name.
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace umbral {

// Calls visit(T{}) for every alternative T of the variant.
template <class Variant, class Visit>
void for_each_kind(Visit&& visit) {
  [&]<std::size_t... I>(std::index_sequence<I...>) { (visit(std::variant_alternative_t<I, Variant>{}), ...); }
  (std::make_index_sequence<std::variant_size_v<Variant>>{});
}

template <class Variant>
std::vector<std::string> kind_names() {
  std::vector<std::string> names;
  for_each_kind<Variant>([&](const auto& value) { names.emplace_back(value.kind); });
  return names;
}

// One of that kind with its default parameters; none if there is no such kind.
template <class Variant>
std::optional<Variant> make_kind(const std::string& kind) {
  std::optional<Variant> made;
  for_each_kind<Variant>([&](auto&& value) {
    if (kind == value.kind) made = std::move(value);  // NOLINT(bugprone-move-*): made for this call
  });
  return made;
}

}  // namespace umbral
