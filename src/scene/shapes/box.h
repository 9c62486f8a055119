// Boxes.
#pragma once

#include <tuple>

#include "core/parameters.h"
#include "scene/shapes/mesh.h"

namespace umbral {

// The box between two corners; each face has its own unit square of uv.
struct Box {
  Vec3 low{-1, -1, -1};
  Vec3 high{1, 1, 1};

  static constexpr const char* kind = "box";
  static constexpr const char* doc = "a box with faces along the axes (turn it by 'transform')";
  static constexpr auto parameters =
      std::tuple{parameter<&Box::low>("low", "the corner with the lowest x, y, z"),
                 parameter<&Box::high>("high", "the corner with the highest x, y, z")};

  Mesh triangulated() const;
};

}  // namespace umbral
