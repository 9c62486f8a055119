// TextureImage: the texels of an image file, and their interpolation.
#pragma once

#include <array>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include "core/math.h"
#include "core/parameters.h"
#include "core/spectrum.h"
#include "image/texels.h"

namespace umbral {

// What the numbers in the file mean. `automatic`: integers are sRGB-encoded, floating-point numbers are
// linear.
enum class ColorSpace { automatic, srgb, linear };

template <>
struct EnumNames<ColorSpace> {
  static constexpr std::array<const char*, 3> names{"automatic", "srgb", "linear"};
};

// How the image goes on outside the unit square; with `none` it does not: there it is black and transparent.
enum class Wrap { repeat, mirror, clamp, none };

template <>
struct EnumNames<Wrap> {
  static constexpr std::array<const char*, 4> names{"repeat", "mirror", "clamp", "none"};
};

enum class TextureFilter { bilinear, nearest };

template <>
struct EnumNames<TextureFilter> {
  static constexpr std::array<const char*, 2> names{"bilinear", "nearest"};
};

// Linear RGB, with alpha in the fourth lane (1 if the file has none). Texel (i, j) counts from the *bottom*
// left: its centre is at ((i + ½)/width, (j + ½)/height) and v points up, so that v = 0 is the last row of
// the file. Grey files give r = g = b. Straight alpha stays straight: colour is not multiplied by it.
class TextureImage {
 public:
  using Texels = std::variant<TexelGrid<Srgb8>, TexelGrid<Linear8>, TexelGrid<Half4>, TexelGrid<Float4>>;

  explicit TextureImage(Texels texels);

  int width() const { return width_; }
  int height() const { return height_; }

  // 0 ≤ x < width, 0 ≤ y < height.
  Spectrum texel(int x, int y) const {
    return std::visit([&](const auto& grid) { return grid.at(x, y); }, texels_);
  }

  // At any uv; one that is not a number counts as 0.
  Spectrum bilinear(const Vec2& uv, Wrap wrap) const;
  Spectrum nearest(const Vec2& uv, Wrap wrap) const;
  Spectrum lookup(const Vec2& uv, Wrap wrap, TextureFilter filter) const {
    return filter == TextureFilter::bilinear ? bilinear(uv, wrap) : nearest(uv, wrap);
  }

  // Whether texels are stored as sRGB codes.
  bool is_srgb() const { return std::holds_alternative<TexelGrid<Srgb8>>(texels_); }
  // Whether some texel's alpha is below 1.
  bool has_alpha() const { return min_max_.first.a < 1; }
  // The smallest and the largest value of each channel.
  const std::pair<Spectrum, Spectrum>& min_max() const { return min_max_; }
  // Of the texels, bytes.
  std::size_t memory() const;

 private:
  Texels texels_;
  int width_, height_;
  std::pair<Spectrum, Spectrum> min_max_;
};

// Reads the first image of any file that OpenImageIO knows. Texels keep the precision of the file: 8 bits,
// half or float; 16-bit integers become float. Values that are NaN, infinite or negative become 0; where
// there were any, a sentence that says how many is added to `repairs`. Throws SceneError if the file is
// missing, unreadable, truncated, empty or larger than 2²⁹ texels.
TextureImage load_texture_image(const std::string& path, ColorSpace color_space,
                                std::vector<std::string>& repairs);

// The same of a file's bytes in memory. `name` is for messages, and its ending tells the format.
TextureImage load_texture_image(std::string_view bytes, const std::string& name, ColorSpace color_space,
                                std::vector<std::string>& repairs);

}  // namespace umbral
