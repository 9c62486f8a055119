// Names of lobes and lobes by name.
#include "bsdf/lobes.h"

namespace umbral {
namespace {

// Calls visit(prototype) for one default-made lobe of every kind.
template <class Visit, std::size_t... I>
void for_each_prototype(Visit&& visit, std::index_sequence<I...>) {
  (visit(std::variant_alternative_t<I, Lobes>{}), ...);
}

template <class Visit>
void for_each_prototype(Visit&& visit) {
  for_each_prototype(visit, std::make_index_sequence<std::variant_size_v<Lobes>>{});
}

}  // namespace

std::vector<std::string> lobe_kinds() {
  std::vector<std::string> kinds;
  for_each_prototype([&](const auto& lobe) { kinds.push_back(lobe.kind); });
  return kinds;
}

std::optional<Lobes> make_lobe(const std::string& kind) {
  std::optional<Lobes> made;
  for_each_prototype([&](const auto& lobe) {
    if (kind == lobe.kind) made = lobe;
  });
  return made;
}

}  // namespace umbral
