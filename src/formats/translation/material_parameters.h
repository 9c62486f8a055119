// Materials out of lobes and the names of their parameters.
#pragma once

#include <map>
#include <string>

#include "scene/material.h"

namespace umbral {

// As it is by itself: opaque and seen from both sides.
inline Material with_lobe(const Lobes& lobe) { return Material{"", lobe, {}, {1}}; }

// Puts the values into the parameters of these names; names that the material's lobe has not are passed over.
template <class T>
void set_parameters(Material& material, const std::map<std::string, Textured<T>>& values) {
  for_each_material_parameter(material, [&](const ParameterInfo& info, auto& textured) {
    if constexpr (std::is_same_v<std::decay_t<decltype(textured)>, Textured<T>>) {
      if (const auto found = values.find(info.name); found != values.end()) textured = found->second;
    }
  });
}

}  // namespace umbral
