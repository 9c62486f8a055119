// Where a procedural texture lies: in uv, or through the space of its object.
#pragma once

#include <array>

#include "core/parameters.h"
#include "scene/textures/texture_point.h"
#include "scene/textures/texture_value.h"

namespace umbral {

enum class TextureSpace { object, uv };

template <>
struct EnumNames<TextureSpace> {
  static constexpr std::array names{"object", "uv"};
};

// What all procedural textures have in common: two colours and a place.
struct NoisePlace {
  Spectrum low = grey(0), high = grey(1);
  TextureSpace space = TextureSpace::object;
  int uv_set = 0;
  float scale = 1;
  TextureChannel channel = TextureChannel::luminance;

  // The point in features: a feature is about 1 wide.
  Vec3 at(const TexturePoint& point) const {
    return scale * (space == TextureSpace::object ? point.p : Vec3(point.uv_of(uv_set), 0));
  }
  unsigned needs() const {
    if (space == TextureSpace::object) return texture_needs::position;
    return uv_set == 0 ? 0 : texture_needs::uv1;
  }
  // `finest`: the smallest feature.
  TextureStep step_of(float finest) const {
    const float step = 0.05f * finest / std::max(std::abs(scale), 1e-6f);
    return space == TextureSpace::object ? TextureStep{infinity, step} : TextureStep{step};
  }
  Vec2 placed(const TexturePoint& point) const { return point.uv_of(uv_set); }
  TextureBounds bounds() const { return {glm::min(low, high), glm::max(low, high)}; }
};

namespace detail {

// The parameters of NoisePlace, as part of those of T.
template <class T>
constexpr auto place_parameters(const char* low, const char* high, const char* scale) {
  return std::tuple{
      parameter<&T::low>("low", low, non_negative),
      parameter<&T::high>("high", high, non_negative),
      parameter<&T::space>("space",
                           "through what it runs: the space of the object (of the world where nothing is "
                           "instanced), or uv"),
      parameter<&T::uv_set>("uv_set", "which uv of a mesh: 0 the first, 1 the second", Range{0, 1}),
      parameter<&T::scale>("scale", scale),
      parameter<&T::channel>("channel", "what a parameter that takes one number gets")};
}

}  // namespace detail

}  // namespace umbral
