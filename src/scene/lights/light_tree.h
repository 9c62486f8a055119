// LightTree: chooses one of many lights by where, how strongly and which way they shine, in the time of its depth.
#pragma once

#include <array>
#include <optional>
#include <span>
#include <vector>

#include "scene/lights/light_bounds.h"

namespace umbral {

// Where light is asked for.
struct LightReceiver {
  Vec3 p;                  // world
  Vec3 n{0};               // geometric normal, unit; 0 where light counts from all sides alike
  bool one_sided = false;  // light from behind n is of no use; else n may point to either side
};

// A binary tree of LightBounds whose leaves are the lights [Conty Estevez and Kulla 2018]. Nodes are chosen by importance,
// an estimate of the irradiance from them, which is zero only where no light below can shine. It is good from some way off
// only, so that a choice is not one between two children, step by step, but one among a cut through the tree that is fine
// where the receiver is near; and then again below the node chosen, down to a light, in the time of the tree's depth.
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

  static constexpr std::size_t deepest = 96;  // no tree is, as the builder makes them
  static constexpr std::size_t widest_cut = 96;
  // Nodes that hold all lights below one between them, each once.
  struct Cut {
    std::size_t size = 0;
    double least = 0,
           sum = 0;  // nodes that can shine count for `least` or more: none may be lost to rounding
    std::array<std::uint32_t, widest_cut> nodes;
    std::array<float, widest_cut> importance;

    double weight(std::size_t i) const {
      return importance[i] > 0 ? std::max(static_cast<double>(importance[i]), least) : 0;
    }
  };

  static constexpr std::uint32_t leaf_bit = 0x80000000u;
  static Node node_of(const LightBounds& bounds, double length_unit, double intensity_unit);
  // The receiver's p is in units of the tree, here and below.
  Cut cut_below(std::uint32_t node, const LightReceiver& receiver) const;
  LightReceiver in_units(const LightReceiver& receiver) const {
    return {receiver.p * per_length_, receiver.n, receiver.one_sided};
  }

  std::vector<Node> nodes_;  // 1 is the root; pairs of siblings are (2k, 2k + 1); 0 is of no meaning
  std::vector<std::uint32_t> parents_;  // of each pair
  std::vector<std::uint32_t> leaves_;   // of each light; 0 where it is never chosen
  float per_length_ = 1;                // 1/unit of length, a power of two
  std::size_t depth_ = 0;
};

}  // namespace umbral
