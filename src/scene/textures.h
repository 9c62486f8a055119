// Textures: functions from uv to a value that a material's parameter or an emission takes.
#pragma once

#include <array>
#include <memory>
#include <string>
#include <tuple>
#include <variant>
#include <vector>

#include "core/parameters.h"
#include "image/texture_image.h"
#include "scene/ids.h"

namespace umbral {

// How uv is placed before a look-up: scaled, then rotated about the origin, then offset.
struct UvTransform {
  Vec2 scale{1, 1};
  float rotation = 0;  // degrees, counter-clockwise in the uv plane
  Vec2 offset{0, 0};
};

// A UvTransform made ready: two multiply-adds a coordinate.
class UvMap {
 public:
  UvMap() = default;
  explicit UvMap(const UvTransform& transform);
  Vec2 operator()(const Vec2& uv) const { return {dot(row_u_, uv) + offset_.x, dot(row_v_, uv) + offset_.y}; }

 private:
  Vec2 row_u_{1, 0}, row_v_{0, 1}, offset_{0, 0};
};

// Which number a texture gives to a parameter that takes one number.
enum class TextureChannel { luminance, r, g, b, a };

template <>
struct EnumNames<TextureChannel> {
  static constexpr std::array names{"luminance", "r", "g", "b", "a"};
};

// The lowest and highest value of each of r, g, b, a.
struct TextureBounds {
  Spectrum low, high;
};

// An image, read from a file.
struct ImageTexture {
  std::string file;
  ColorSpace color_space = ColorSpace::automatic;
  Wrap wrap = Wrap::repeat;
  TextureFilter filter = TextureFilter::bilinear;
  TextureChannel channel = TextureChannel::luminance;
  float factor = 1, bias = 0;
  Vec2 uv_scale{1, 1};
  float uv_rotation = 0;
  Vec2 uv_offset{0, 0};

  static constexpr const char* kind = "image";
  static constexpr const char* doc = "an image file: value = texel × factor + bias";
  static constexpr auto parameters =
      std::tuple{required<&ImageTexture::file>("file", "image file, relative to the scene file"),
                 parameter<&ImageTexture::color_space>(
                     "color_space", "how texels are stored; automatic: 8-bit is sRGB, float linear"),
                 parameter<&ImageTexture::wrap>("wrap", "what lies beyond the unit square"),
                 parameter<&ImageTexture::filter>("filter", "how texels are joined"),
                 parameter<&ImageTexture::channel>("channel", "what a parameter that takes one number gets"),
                 parameter<&ImageTexture::factor>("factor", "multiplies each texel"),
                 parameter<&ImageTexture::bias>("bias", "is added after the factor"),
                 parameter<&ImageTexture::uv_scale>("uv_scale", "repeats of the image in u and v"),
                 parameter<&ImageTexture::uv_rotation>("uv_rotation", "degrees, counter-clockwise"),
                 parameter<&ImageTexture::uv_offset>("uv_offset", "in repeats, after scale and rotation")};

  // What the reader loads; the texture cannot be evaluated before.
  std::shared_ptr<const TextureImage> image = nullptr;
  UvMap uv_map{};

  void prepare() { uv_map = UvMap({uv_scale, uv_rotation, uv_offset}); }
  Spectrum evaluate(const Vec2& uv) const;  // r, g, b and alpha
  TextureBounds bounds() const;
};

// Two colours in alternate squares.
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

// The closed list of textures. A new one is its own struct and one line here.
using TextureKinds = std::variant<ImageTexture, CheckerTexture>;

struct Texture {
  std::string name;
  TextureKinds kind;

  void prepare();
  Spectrum color(const Vec2& uv) const;
  float number(const Vec2& uv) const;  // the chosen channel
  TextureBounds color_bounds() const;
  Range number_bounds() const;
};

}  // namespace umbral
