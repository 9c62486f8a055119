// LightChooser: which light a path asks, and with what probability.
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "core/distribution.h"
#include "core/parameters.h"
#include "scene/ids.h"
#include "scene/lights/light_tree.h"

namespace umbral {

enum class LightSelection { tree, power, uniform };

template <>
struct EnumNames<LightSelection> {
  static constexpr std::array names{"tree", "power", "uniform"};
};

struct LightChoice {
  LightId light = LightId::none;
  float probability = 0;
};

// What is to be known of each light.
struct LightFacts {
  double power = 0;                   // W; 0 is never chosen
  std::optional<LightBounds> bounds;  // none of lights that are everywhere or infinitely far
};

// A light by one of three rules: all that shine alike; by power, of which a share is dealt alike; or by a tree over those
// that have a place, beside which those without share a probability of their own by power. With no light that has a
// place, or one that shines in all, the tree is power.
class LightChooser {
 public:
  LightChooser() = default;
  explicit LightChooser(const std::vector<LightFacts>& lights);

  std::size_t size() const { return count_; }
  bool has_tree() const { return !tree_.empty(); }
  // By u in [0, 1); none where there is no light, or none that can shine on the receiver.
  LightChoice choose(LightSelection selection, const LightReceiver& receiver, float u) const {
    if (count_ == 1) return {static_cast<LightId>(0), 1};
    return choose_among(selection, receiver, u);
  }
  float probability(LightSelection selection, const LightReceiver& receiver, LightId light) const {
    if (count_ == 1) return 1;
    return probability_among(selection, receiver, light);
  }

 private:
  LightChoice choose_among(LightSelection selection, const LightReceiver& receiver, float u) const;
  float probability_among(LightSelection selection, const LightReceiver& receiver, LightId light) const;
  void plant(const std::vector<LightFacts>& lights);

  std::size_t count_ = 0;
  Distribution1D power_, uniform_;
  LightTree tree_;            // empty where power serves
  Distribution1D boundless_;  // those without bounds, as indices of all; with a tree
  float boundless_share_ = 0;
};

}  // namespace umbral
