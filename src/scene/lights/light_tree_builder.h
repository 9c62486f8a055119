// The shape of a light tree: which lights lie together.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "scene/lights/light_bounds.h"

namespace umbral {

struct LightTreeLayout {
  struct Node {
    LightBounds bounds;
    std::uint32_t next = 0;  // the first of two neighbouring children, at an even place; the light of a leaf
    bool is_leaf = false;
  };
  std::vector<Node> nodes;  // 0 is empty, 1 the root; none at all where no light has intensity
  std::size_t depth = 0;
};

// Splits where the surface area orientation heuristic is least, among buckets along each axis; in halves where that
// cannot tell or would make the tree much deeper than a balanced one.
LightTreeLayout light_tree_layout(std::span<const LightBounds> lights);

}  // namespace umbral
