// Lobes of any kind with parameters from all over their ranges, made from their own tables of parameters.
#pragma once

#include <vector>

#include "bsdf/lobes.h"
#include "support/random.h"

namespace umbral::test {

/// Writes a random allowed value into each number or colour that it visits: often an end of the range, else evenly
/// or logarithmically between.
class RandomParameters {
 public:
  explicit RandomParameters(Random& random) : random_(random) {}

  template <class E>
    requires std::is_enum_v<E>
  void operator()(const ParameterInfo&, E& value) {
    value = static_cast<E>(random_.below(EnumNames<E>::names.size()));
  }
  void operator()(const ParameterInfo&, bool& value) { value = random_.coin(); }
  void operator()(const ParameterInfo& info, float& value) { value = number(info.range); }
  void operator()(const ParameterInfo& info, Spectrum& value) {
    const float r = number(info.range);
    const float g = number(info.range);
    const float b = number(info.range);
    value = rgb(r, g, b);
  }

 private:
  float number(const Range& range) {
    const float low = std::isfinite(range.low) ? range.low : -1e3f;
    const float high = std::isfinite(range.high) ? range.high : 1e3f;
    switch (random_.below(6)) {
      case 0:
        return range.low_open ? std::nextafter(low, high) : low;
      case 1:
        return range.high_open ? std::nextafter(high, low) : high;
      case 2:
      case 3:
        return low + (high - low) * static_cast<float>(random_.log_between(1e-6, 1));
      default:
        return low + (high - low) * random_.number();
    }
  }

  Random& random_;
};

template <class Lobe>
void take_film_off(Lobe& lobe) {
  if constexpr (requires { lobe.film_thickness; }) lobe.film_thickness = 0;
  if constexpr (requires { lobe.iridescence; }) lobe.iridescence = 0;
}

/// `count` lobes, the first with the default parameters; always the same ones. Every third may have a thin film: what
/// that reflects takes ten times as long to work out.
template <class Lobe>
std::vector<Lobe> lobe_examples(int count) {
  Random random(20240611);
  std::vector<Lobe> lobes(1);
  while (static_cast<int>(lobes.size()) < count) {
    Lobe lobe;
    for_each_parameter(lobe, RandomParameters(random));
    if (lobes.size() % 3 != 0) take_film_off(lobe);
    lobes.push_back(lobe);
  }
  return lobes;
}

/// Whether light passes through the lobe, and whether its radiance is changed by that, by the square of an index.
template <class Lobe>
inline constexpr bool transmits = requires {
  Lobe::transmits;
};
template <class Lobe>
inline constexpr bool refracts = requires(const Lobe& lobe) {
  lobe.interior_eta();
};

/// By how much a lobe may reflect more than arrives: the error of the quadrature, and of the tables it is compensated by.
template <class Lobe>
inline constexpr double albedo_excess = 2e-5;
template <>
inline constexpr double albedo_excess<Conductor> = 0.01;
template <>
inline constexpr double albedo_excess<Dielectric> = 0.01;
template <>
inline constexpr double albedo_excess<Plastic> = 3e-3;
template <>
inline constexpr double albedo_excess<Principled> = 0.01;
template <>
inline constexpr double albedo_excess<Coat> = 0.01;
template <>
inline constexpr double albedo_excess<Sheen> = 0.01;

/// The unit vector with this z and azimuth (radians).
inline Vec3 direction_at(double z, double phi) {
  const double r = std::sqrt(std::max(0.0, 1 - z * z));
  return Vec3(Vec3d(r * std::cos(phi), r * std::sin(phi), z));
}

inline Vec3 flipped(const Vec3& w) { return {w.x, w.y, -w.z}; }

}  // namespace umbral::test
