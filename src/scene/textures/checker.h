// Two colours in alternate squares.
#pragma once

#include <tuple>

#include "core/parameters.h"
#include "scene/textures/texture_point.h"
#include "scene/textures/texture_value.h"
#include "scene/textures/uv_map.h"

namespace umbral {

struct CheckerTexture {
  Spectrum even = grey(0.8f), odd = grey(0.2f);
  Vec2 uv_scale{8, 8};
  float uv_rotation = 0;
  Vec2 uv_offset{0, 0};
  int uv_set = 0;
  TextureChannel channel = TextureChannel::luminance;

  static constexpr const char* kind = "checker";
  static constexpr const char* doc = "two colours in alternate squares";
  static constexpr auto parameters = std::tuple{
      parameter<&CheckerTexture::even>("even", "colour of the square at the uv origin", non_negative),
      parameter<&CheckerTexture::odd>("odd", "colour of its neighbours", non_negative),
      parameter<&CheckerTexture::uv_scale>("uv_scale", "squares per unit of u and v"),
      parameter<&CheckerTexture::uv_rotation>("uv_rotation", "degrees, counter-clockwise"),
      parameter<&CheckerTexture::uv_offset>("uv_offset", "in squares, after scale and rotation"),
      parameter<&CheckerTexture::uv_set>("uv_set", "which uv of a mesh: 0 the first, 1 the second",
                                         Range{0, 1}),
      parameter<&CheckerTexture::channel>("channel", "what a parameter that takes one number gets")};

  UvMap uv_map{};

  void prepare() { uv_map = UvMap({uv_scale, uv_rotation, uv_offset}); }
  Spectrum evaluate(const TexturePoint& point) const;
  TextureBounds bounds() const;
  unsigned needs() const { return uv_set == 0 ? 0 : texture_needs::uv1; }
  TextureStep step() const { return {1e-3f / std::max({std::abs(uv_scale.x), std::abs(uv_scale.y), 1e-6f})}; }
  Vec2 placed(const TexturePoint& point) const { return uv_map(point.uv_of(uv_set)); }
};

}  // namespace umbral
