// Lobes of any kind with parameters from all over their ranges, made from their own tables of parameters.
#pragma once

#include <deque>
#include <string_view>
#include <vector>

#include "bsdf/lobes.h"
#include "core/kinds.h"
#include "support/matte_parts.h"
#include "support/random.h"

namespace umbral::test {

/// One of some hundred lobes of all kinds that are not made of others; that lets no light through if `opaque`.
const Lobes& random_part(Random& random, bool opaque);

/// Writes a random allowed value into each number or colour that it visits: often an end of the range, else evenly
/// or logarithmically between. Of the lobes that one is made of, `a` alone may let light through: two would have to agree
/// about what is behind them.
class RandomParameters {
 public:
  explicit RandomParameters(Random& random) : random_(random) {}

  template <class E>
    requires std::is_enum_v<E>
  void operator()(const ParameterInfo&, E& value) {
    value = static_cast<E>(random_.below(EnumNames<E>::names.size()));
  }
  void operator()(const ParameterInfo&, bool& value) { value = random_.coin(); }
  void operator()(const ParameterInfo& info, const Lobes*& value) {
    value = &random_part(random_, std::string_view(info.name) != "a");
  }
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

/// `count` lobes, the first with the default parameters (made of matte ones, if it is made of others); always the same ones. Every third may have a thin film: what
/// that reflects takes ten times as long to work out.
template <class Lobe>
std::vector<Lobe> lobe_examples(int count) {
  Random random(20240611);
  std::vector<Lobe> lobes{with_matte_parts(Lobe{})};
  while (static_cast<int>(lobes.size()) < count) {
    Lobe lobe;
    for_each_parameter(lobe, RandomParameters(random));
    if (lobes.size() % 3 != 0) take_film_off(lobe);
    lobes.push_back(lobe);
  }
  return lobes;
}

inline const Lobes& random_part(Random& random, bool opaque) {
  static const std::deque<Lobes> parts = [] {
    std::deque<Lobes> made;
    for_each_kind<Lobes>([&](const auto& kind) {
      using Lobe = std::remove_cvref_t<decltype(kind)>;
      if constexpr (!std::is_same_v<Lobe, Mix> && !std::is_same_v<Lobe, Coat>)
        for (Lobe lobe : lobe_examples<Lobe>(12)) {
          take_film_off(lobe);
          made.push_back(lobe);
        }
    });
    return made;
  }();
  for (;;) {
    const Lobes& part = parts[random.below(parts.size())];
    if (!opaque || !umbral::transmits(part)) return part;
  }
}

/// The index of what is behind the surface, by the square of which radiance is changed on the way in; 1 where light does
/// not go in by refraction.
template <class Lobe>
float inner_index(const Lobe& lobe) {
  if constexpr (std::is_same_v<Lobe, Mix>)
    return visit_lobe(*lobe.a, [](const auto& part) { return inner_index(part); });
  else if constexpr (requires { lobe.interior_eta(); })
    return lobe.interior_eta();
  else
    return 1;
}

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
inline constexpr double albedo_excess<Mix> = 0.01;
template <>
inline constexpr double albedo_excess<Sheen> = 0.01;

/// The unit vector with this z and azimuth (radians).
inline Vec3 direction_at(double z, double phi) {
  const double r = std::sqrt(std::max(0.0, 1 - z * z));
  return Vec3(Vec3d(r * std::cos(phi), r * std::sin(phi), z));
}

inline Vec3 flipped(const Vec3& w) { return {w.x, w.y, -w.z}; }

}  // namespace umbral::test
