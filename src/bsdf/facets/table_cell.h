// Where a number lies among the nodes of a table.
#pragma once

#include "core/math.h"

namespace umbral {

// x in [0, 1] among `count` even nodes: between i and i + 1.
struct Cell {
  int i;
  float t;
};

inline Cell cell_of(float x, int count) {
  const float at = glm::clamp(x, 0.0f, 1.0f) * static_cast<float>(count - 1);
  const int i = std::min(static_cast<int>(at), count - 2);
  return {i, at - static_cast<float>(i)};
}

inline float node(int i, int count) { return static_cast<float>(i) / static_cast<float>(count - 1); }

}  // namespace umbral
