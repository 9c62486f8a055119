// Two colours in alternate squares.
#pragma once

#include <tuple>

#include "core/parameters.h"
#include "scene/textures/texture_value.h"
#include "scene/textures/uv_map.h"

namespace umbral {

struct CheckerTexture {
  Spectrum even = grey(0.8f), odd = grey(0.2f);
  Vec2 uv_scale{8, 8};
  float uv_rotation = 0;
  Vec2 uv_offset{0, 0};
  TextureChannel channel = TextureChannel::luminance;

  static constexpr const char* kind = "checker";
  static constexpr const char* doc = "two colours in alternate squares";
  static constexpr auto parameters = std::tuple{
      parameter<&CheckerTexture::even>("even", "colour of the square at the uv origin", non_negative),
      parameter<&CheckerTexture::odd>("odd", "colour of its neighbours", non_negative),
      parameter<&CheckerTexture::uv_scale>("uv_scale", "squares per unit of u and v"),
      parameter<&CheckerTexture::uv_rotation>("uv_rotation", "degrees, counter-clockwise"),
      parameter<&CheckerTexture::uv_offset>("uv_offset", "in squares, after scale and rotation"),
      parameter<&CheckerTexture::channel>("channel", "what a parameter that takes one number gets")};

  UvMap uv_map{};

  void prepare() { uv_map = UvMap({uv_scale, uv_rotation, uv_offset}); }
  Spectrum evaluate(const Vec2& uv) const;
  TextureBounds bounds() const;
};

}  // namespace umbral
