// Random numbers for tests: the same on every machine and compiler.
#pragma once

#include <cmath>
#include <cstdint>
#include <random>

#include "core/math.h"

namespace umbral::test {

/// Numbers with 24 random bits, as samplers give them; one call draws one number.
class Random {
 public:
  explicit Random(std::uint64_t seed) : engine_(seed) {}

  float number() { return static_cast<float>(engine_() >> 40) * 0x1p-24f; }  // in [0, 1)
  double between(double low, double high) {
    return low + (high - low) * (static_cast<double>(engine_() >> 11) * 0x1p-53);
  }
  double log_between(double low, double high) { return std::exp(between(std::log(low), std::log(high))); }
  std::size_t below(std::size_t n) { return static_cast<std::size_t>(engine_() % n); }
  bool coin() { return (engine_() >> 63) != 0; }

  Vec2 square() {
    const float x = number();
    const float y = number();
    return {x, y};
  }

  /// Each component between −size and size.
  Vec3d in_cube(double size) {
    const double x = between(-size, size);
    const double y = between(-size, size);
    const double z = between(-size, size);
    return {x, y, z};
  }

  /// Uniform on the unit sphere.
  Vec3d direction() {
    const double z = between(-1, 1);
    const double phi = between(0, 2 * pi_d);
    const double r = std::sqrt(1 - z * z);
    return {r * std::cos(phi), r * std::sin(phi), z};
  }

 private:
  std::mt19937_64 engine_;
};

}  // namespace umbral::test
