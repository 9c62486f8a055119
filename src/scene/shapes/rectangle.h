// Rectangles and other parallelograms.
#pragma once

#include <tuple>

#include "core/parameters.h"
#include "scene/shapes/mesh.h"

namespace umbral {

// origin + u edge_u + v edge_v, u and v in [0, 1]; its outer side is that of edge_u × edge_v.
struct Rectangle {
  Vec3 origin{-1, -1, 0};
  Vec3 edge_u{2, 0, 0};
  Vec3 edge_v{0, 2, 0};

  static constexpr const char* kind = "rectangle";
  static constexpr const char* doc = "a flat parallelogram; faces the way of edge_u × edge_v";
  static constexpr auto parameters =
      std::tuple{parameter<&Rectangle::origin>("origin", "the corner where u = v = 0"),
                 parameter<&Rectangle::edge_u>("edge_u", "from the origin to the corner u = 1"),
                 parameter<&Rectangle::edge_v>("edge_v", "from the origin to the corner v = 1")};

  Mesh triangulated() const;
};

}  // namespace umbral
