// Which of a scene's own materials stand in the place of those of a file that it includes.
#pragma once

#include <map>
#include <optional>
#include <string>

#include "scene/ids.h"

namespace umbral {

// Emission stays the file's.
struct MaterialOverrides {
  std::optional<MaterialId> all;
  std::map<std::string, MaterialId> by_name;  // of the file's materials

  std::optional<MaterialId> find(const std::string& name) const {
    const auto named = by_name.find(name);
    return named == by_name.end() ? all : named->second;
  }
};

}  // namespace umbral
