// How a file of another program comes into a scene.
#pragma once

#include <map>
#include <optional>
#include <string>

#include "scene/ids.h"
#include "scene/transform.h"

namespace umbral {

// Which of the scene's own materials stand in the place of the file's. Emission stays the file's.
struct MaterialOverrides {
  std::optional<MaterialId> all;
  std::map<std::string, MaterialId> by_name;  // of the file's materials

  std::optional<MaterialId> find(const std::string& name) const {
    const auto named = by_name.find(name);
    return named == by_name.end() ? all : named->second;
  }
};

struct Inclusion {
  Affine to_world = {};  // from the file's own world
  MaterialOverrides overrides = {};
};

}  // namespace umbral
