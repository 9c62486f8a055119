// What a lobe reflects and lets through in all, by the mean weight of its draws.
#pragma once

#include "lobe_examples.h"

namespace umbral::test {

struct Albedo {
  double mean, error;  // standard error
};

/// The change of radiance between media is undone. u1 is stratified.
template <class Lobe>
Albedo albedo_by_draws(const Lobe& lobe, const Vec3& wo, int draws = 20'000) {
  Random random(11);
  double sum = 0, squares = 0;
  for (int i = 0; i < draws; ++i) {
    const float u1 = (static_cast<float>(i) + random.number()) / static_cast<float>(draws);
    const auto sample = lobe.sample(wo, std::min(u1, one_minus_epsilon), random.square());
    if (!sample) continue;
    const float eta = same_side(wo, sample->wi) ? 1 : inner_index(lobe);
    const double weight = sample->weight.g * sqr(wo.z > 0 ? eta : 1 / eta);
    sum += weight;
    squares += sqr(weight);
  }
  const double mean = sum / draws;
  return {mean, std::sqrt(std::max(0.0, squares / draws - mean * mean) / draws)};
}

}  // namespace umbral::test
