// Distributions with known means that stand for what samples of radiance are like.
#pragma once

#include <array>
#include <cmath>

#include "support/random.h"

namespace umbral::test {

enum class Draw { uniform, lognormal_1, lognormal_1_5, firefly, bernoulli };

inline constexpr std::array<const char*, 5> draw_names{"uniform", "lognormal, σ = 1", "lognormal, σ = 1.5",
                                                       "uniform + 100 once in 1000", "1 once in 100"};

inline double mean_of(Draw draw) {
  switch (draw) {
    case Draw::uniform:
      return 0.5;
    case Draw::lognormal_1:
      return std::exp(0.5);
    case Draw::lognormal_1_5:
      return std::exp(0.5 * 1.5 * 1.5);
    case Draw::firefly:
      return 0.6;
    case Draw::bernoulli:
      return 0.01;
  }
  return 0;
}

inline double drawn(Draw draw, Random& random) {
  const auto normal = [&] {
    const double u = random.between(1e-16, 1), v = random.between(0, 2 * pi_d);
    return std::sqrt(-2 * std::log(u)) * std::cos(v);
  };
  switch (draw) {
    case Draw::uniform:
      return random.between(0, 1);
    case Draw::lognormal_1:
      return std::exp(normal());
    case Draw::lognormal_1_5:
      return std::exp(1.5 * normal());
    case Draw::firefly: {
      const double u = random.between(0, 1);
      return u + (random.between(0, 1) < 1e-3 ? 100 : 0);
    }
    case Draw::bernoulli:
      return random.between(0, 1) < 0.01 ? 1 : 0;
  }
  return 0;
}

}  // namespace umbral::test
