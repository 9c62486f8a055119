// A texture from an image file.
#pragma once

#include <array>
#include <memory>
#include <string>
#include <string_view>
#include <tuple>
#include <vector>

#include "core/parameters.h"
#include "image/texture_image.h"
#include "scene/textures/texture_point.h"
#include "scene/textures/texture_value.h"
#include "scene/textures/uv_map.h"

namespace umbral {

// The images of a file name with <UDIM>: tile 1001 + u + 10 v lies on the uv square (u, v).
struct UdimTiles {
  static constexpr std::string_view mark = "<UDIM>";
  static constexpr int columns = 10, first = 1001;
  std::vector<std::shared_ptr<const TextureImage>> images;  // by number − 1001; null where there is none

  // The name of one of the files.
  static std::string file_of(std::string name, int number) {
    return name.replace(name.find(mark), mark.size(), std::to_string(number));
  }
  const TextureImage* at(const Vec2& square) const {
    if (!(square.x >= 0 && square.x < columns && square.y >= 0 && square.y < 1000)) return nullptr;
    const auto index = static_cast<std::size_t>(square.x) + columns * static_cast<std::size_t>(square.y);
    return index < images.size() ? images[index].get() : nullptr;
  }
};

// The wrap in v, where it is not that in u.
enum class WrapV { as_u, repeat, mirror, clamp, none };

template <>
struct EnumNames<WrapV> {
  static constexpr std::array names{"as_u", "repeat", "mirror", "clamp", "none"};
};

struct ImageTexture {
  std::string file;
  ColorSpace color_space = ColorSpace::automatic;
  Wrap wrap = Wrap::repeat;
  WrapV wrap_v = WrapV::as_u;
  TextureFilter filter = TextureFilter::bilinear;
  TextureChannel channel = TextureChannel::luminance;
  float factor = 1, bias = 0;
  Vec2 uv_scale{1, 1};
  float uv_rotation = 0;
  Vec2 uv_offset{0, 0};
  int uv_set = 0;

  static constexpr const char* kind = "image";
  static constexpr const char* doc = "an image file: value = texel × factor + bias";
  static constexpr auto parameters =
      std::tuple{required<&ImageTexture::file>(
                     "file", "image file, relative to the scene file; <UDIM> in it stands for 1001, 1002, …"),
                 parameter<&ImageTexture::color_space>(
                     "color_space", "how texels are stored; automatic: 8-bit is sRGB, float linear"),
                 parameter<&ImageTexture::wrap>("wrap", "what lies beyond the unit square"),
                 parameter<&ImageTexture::wrap_v>("wrap_v", "the same in v alone, where it differs from u"),
                 parameter<&ImageTexture::filter>("filter", "how texels are joined"),
                 parameter<&ImageTexture::channel>("channel", "what a parameter that takes one number gets"),
                 parameter<&ImageTexture::factor>("factor", "multiplies each texel"),
                 parameter<&ImageTexture::bias>("bias", "is added after the factor"),
                 parameter<&ImageTexture::uv_scale>("uv_scale", "repeats of the image in u and v"),
                 parameter<&ImageTexture::uv_rotation>("uv_rotation", "degrees, counter-clockwise"),
                 parameter<&ImageTexture::uv_offset>("uv_offset", "in repeats, after scale and rotation"),
                 parameter<&ImageTexture::uv_set>("uv_set", "which uv of a mesh: 0 the first, 1 the second",
                                                  Range{0, 1})};

  // What the reader loads; the texture cannot be evaluated before.
  std::shared_ptr<const TextureImage> image = nullptr;
  std::shared_ptr<const UdimTiles> tiles = nullptr;  // where the file is many; `image` is then one of them
  UvMap uv_map{};
  float footprint_scale = 1;  // of widths in uv, by uv_map

  void prepare() {
    uv_map = UvMap({uv_scale, uv_rotation, uv_offset});
    footprint_scale = std::sqrt(std::abs(uv_scale.x * uv_scale.y));
  }
  Spectrum evaluate(const TexturePoint& point) const;  // r, g, b and alpha
  TextureBounds bounds() const;
  unsigned needs() const;
  TextureStep step() const;
  Wraps wraps() const {
    return wrap_v == WrapV::as_u ? Wraps(wrap) : Wraps(wrap, static_cast<Wrap>(static_cast<int>(wrap_v) - 1));
  }
  Vec2 placed(const TexturePoint& point) const { return uv_map(point.uv_of(uv_set)); }
};

}  // namespace umbral
