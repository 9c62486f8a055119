// The three rules.
#include "scene/lights/light_chooser.h"

namespace umbral {
namespace {

// By power, a tenth of the mean more for each that shines: a lamp's power may be as nothing against the sun's, over all
// the scene, and the lamp be the brightest light where it stands.
Distribution1D by_power(std::vector<double> powers) {
  double sum = 0;
  for (const double power : powers) sum += power;
  const double even = 0.1 * sum / static_cast<double>(powers.size());
  for (double& weight : powers)
    if (weight > 0) weight += even;
  return Distribution1D(powers);
}

}  // namespace

LightChooser::LightChooser(const std::vector<LightFacts>& lights) : count_(lights.size()) {
  std::vector<double> powers, shining;
  for (const LightFacts& light : lights) {
    powers.push_back(light.power);
    shining.push_back(light.power > 0 ? 1 : 0);
  }
  uniform_ = Distribution1D(shining);
  plant(lights);
  power_ = by_power(std::move(powers));
}

void LightChooser::plant(const std::vector<LightFacts>& lights) {
  std::vector<LightBounds> bounds;
  std::vector<double> boundless;
  double here = 0, far = 0;
  std::size_t placed = 0;
  for (const LightFacts& light : lights) {
    const bool has_place = light.bounds && light.bounds->intensity > 0;
    bounds.push_back(has_place ? *light.bounds : LightBounds{});
    boundless.push_back(has_place ? 0 : light.power);
    (has_place ? here : far) += light.power;
    placed += has_place ? 1 : 0;
  }
  if (placed == 0 || (placed == 1 && !(far > 0))) return;
  tree_ = LightTree(bounds);
  // Which of the two is the brighter one depends on the place; neither is left to less than a quarter.
  if (!(far > 0)) return;
  boundless_share_ = static_cast<float>(glm::clamp(far / (far + here), 0.25, 0.75));
  boundless_ = by_power(std::move(boundless));
}

LightChoice LightChooser::choose_among(LightSelection selection, const LightReceiver& receiver,
                                       float u) const {
  if (count_ == 0) return {};
  if (selection == LightSelection::tree && has_tree()) {
    if (u < boundless_share_) {
      const Distribution1D::Draw draw = boundless_.sample(std::min(u / boundless_share_, one_minus_epsilon));
      return {static_cast<LightId>(draw.index), boundless_share_ * draw.probability};
    }
    const float share = 1 - boundless_share_;
    const auto choice = tree_.choose(receiver, std::min((u - boundless_share_) / share, one_minus_epsilon));
    if (!choice) return {};
    return {static_cast<LightId>(choice->light), share * choice->probability};
  }
  const Distribution1D::Draw draw = (selection == LightSelection::uniform ? uniform_ : power_).sample(u);
  return {static_cast<LightId>(draw.index), draw.probability};
}

float LightChooser::probability_among(LightSelection selection, const LightReceiver& receiver,
                                      LightId light) const {
  const std::uint32_t index = index_of(light);
  if (selection == LightSelection::tree && has_tree()) {
    if (boundless_share_ > 0 && boundless_.probability(index) > 0)
      return boundless_share_ * boundless_.probability(index);
    return (1 - boundless_share_) * tree_.probability(receiver, index);
  }
  return (selection == LightSelection::uniform ? uniform_ : power_).probability(index);
}

}  // namespace umbral
