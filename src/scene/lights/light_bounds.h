// LightBounds: where a light or a group of them is, which way it shines, and how strongly.
#pragma once

#include "scene/shapes/parametric.h"

namespace umbral {

// The directions within an angle of an axis.
struct DirectionCone {
  Vec3d axis{0, 0, 1};  // unit
  double angle = 0;     // radians, 0 … π; π holds every direction
};

// The smallest cone around two; either may be turned round first where `two_sided`.
DirectionCone cone_around(const DirectionCone& a, DirectionCone b, bool two_sided);

// Light leaves within `fade` radians of a direction of `normals` and nowhere else [Conty Estevez and Kulla 2018]; from
// two-sided ones against those directions too.
struct LightBounds {
  Bounds box{Vec3d(HUGE_VAL), Vec3d(-HUGE_VAL)};  // world
  double radius = 0;  // of a sphere around the middle of the box that holds the light
  DirectionCone normals{{0, 0, 1}, pi_d};
  double fade = pi_d / 2;
  double intensity = 0;  // luminance of the radiant intensity where it is largest, about; W/sr
  bool two_sided = false;

  Vec3d middle() const { return (box.low + box.high) / 2.0; }
};

// Of a point that shines everywhere.
LightBounds bounds_of_point(const Vec3d& p, double intensity);

LightBounds bounds_around(const LightBounds& a, const LightBounds& b);

// What a group costs to sample: light spread over space and directions, the surface area orientation heuristic of
// Conty Estevez and Kulla, without the term that is for the way of the split.
double orientation_cost(const LightBounds& bounds);

}  // namespace umbral
