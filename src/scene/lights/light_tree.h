// LightTree: chooses one of many lights by where, how strongly and which way they shine, in the time of its depth.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "scene/lights/light_bounds.h"

namespace umbral {

// Where light is asked for.
struct LightReceiver {
  Vec3 p;     // world
  Vec3 n{0};  // geometric normal, unit, either side; 0 where light counts from all sides alike
};

// A binary tree of LightBounds whose leaves are the lights [Conty Estevez and Kulla 2018]. A choice goes down from the
// root, to each child with the share of its importance: an estimate of the irradiance from it, which is zero only where
// no light below it can shine. Lights on both sides of the receiver count, because surfaces may transmit.
class LightTree {
 public:
  struct Choice {
    std::uint32_t light;
    float probability;
    float remainder;  // of u: uniform again, in [0, 1)
  };

  LightTree() = default;
  // Light i has bounds[i]; those without intensity are never chosen.
  explicit LightTree(std::span<const LightBounds> bounds);

  bool empty() const { return nodes_.empty(); }
  std::size_t depth() const { return depth_; }
  std::size_t bytes() const;

  // By u in [0, 1); none where no light can shine on the receiver.
  std::optional<Choice> choose(const LightReceiver& receiver, float u) const;
  // Of choose(); 0 for lights that it does not choose.
  float probability(const LightReceiver& receiver, std::uint32_t light) const;

 private:
  // LightBounds as importance() wants them; lengths and intensities in units of the tree. Siblings are neighbours.
  struct Node {
    Vec3 middle;
    float radius2;
    Vec3 axis;
    float intensity;
    float cos_normals, sin_normals;
    float cos_fade;      // −2 where light leaves in every direction
    std::uint32_t next;  // the first of two children, or the light with the highest bit set
    bool two_sided;
  };

  static constexpr std::uint32_t leaf_bit = 0x80000000u;
  static Node node_of(const LightBounds& bounds, double length_unit, double intensity_unit);
  static float importance(const Node& node, const Vec3& p, const Vec3& n);
  double share_of_first(std::uint32_t pair, const Vec3& p, const Vec3& n) const;

  std::vector<Node> nodes_;  // 1 is the root; pairs of siblings are (2k, 2k + 1); 0 is of no meaning
  std::vector<std::uint32_t> parents_;  // of each pair
  std::vector<std::uint32_t> leaves_;   // of each light; 0 where it is never chosen
  float per_length_ = 1;                // 1/unit of length, a power of two
  std::size_t depth_ = 0;
};

}  // namespace umbral
