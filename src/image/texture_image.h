// TextureImage: the texels of an image file, and their interpolation.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include "core/math.h"
#include "core/parameters.h"
#include "core/spectrum.h"
#include "image/texels.h"
#include "image/texture_memory.h"

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

// In u and in v.
struct Wraps {
  Wrap u, v;
  Wraps(Wrap both) : u(both), v(both) {}  // NOLINT(google-explicit-constructor): one for both nearly always
  Wraps(Wrap u_, Wrap v_) : u(u_), v(v_) {}
};

// How texels are joined. `stochastic`: one of the four, with the probability that is its weight [Pharr et al. 2024]: the
// mean is that of bilinear. `mip`: likewise, of two levels of detail, chosen by the width that the look-up stands for.
enum class TextureFilter { bilinear, nearest, stochastic, mip };

template <>
struct EnumNames<TextureFilter> {
  static constexpr std::array<const char*, 4> names{"bilinear", "nearest", "stochastic", "mip"};
};

// What filters beyond bilinear look at.
struct TextureFootprint {
  float width = 0;           // of what the look-up stands for, in texels of the finest level
  std::uint32_t random = 0;  // chooses texels and levels; 0: all are interpolated
};

// Linear RGB, with alpha in the fourth lane (1 if the file has none). Texel (i, j) counts from the *bottom*
// left: its centre is at ((i + ½)/width, (j + ½)/height) and v points up, so that v = 0 is the last row of
// the file. Grey files give r = g = b. Straight alpha stays straight: colour is not multiplied by it.
class TextureImage {
 public:
  using Texels =
      std::variant<TexelGrid<Srgb8>, TexelGrid<Linear8>, TexelGrid<Half4>, TexelGrid<Float4>, CachedTexels>;

  explicit TextureImage(Texels texels);

  int width() const { return width_; }
  int height() const { return height_; }

  // 0 ≤ x < width, 0 ≤ y < height.
  Spectrum texel(int x, int y) const {
    return std::visit([&](const auto& grid) { return grid.at(x, y); }, texels_);
  }

  // At any uv; one that is not a number counts as 0.
  Spectrum bilinear(const Vec2& uv, Wraps wraps) const;
  Spectrum nearest(const Vec2& uv, Wraps wraps) const;
  Spectrum lookup(const Vec2& uv, Wraps wraps, TextureFilter filter,
                  const TextureFootprint& footprint = {}) const {
    if (filter == TextureFilter::bilinear) return bilinear(uv, wraps);
    return filter == TextureFilter::nearest ? nearest(uv, wraps)
                                            : filtered(uv, wraps, filter == TextureFilter::mip, footprint);
  }

  // Adds the levels of detail that `mip` wants; without them it sees the finest alone.
  void build_levels();
  int level_count() const { return 1 + static_cast<int>(levels_.size()); }

  // Whether texels are stored as sRGB codes.
  bool is_srgb() const {
    const auto* cached = std::get_if<CachedTexels>(&texels_);
    return cached ? cached->is_srgb() : std::holds_alternative<TexelGrid<Srgb8>>(texels_);
  }
  // Whether some texel's alpha is below 1.
  bool has_alpha() const { return min_max_.first.a < 1; }
  // The smallest and the largest value of each channel.
  const std::pair<Spectrum, Spectrum>& min_max() const { return min_max_; }
  // Of the texels of all levels, bytes.
  std::size_t memory() const;

 private:
  Spectrum filtered(const Vec2& uv, Wraps wraps, bool by_level, const TextureFootprint& footprint) const;

  Texels texels_;
  std::vector<Texels> levels_;  // from half the size on
  int width_, height_;
  std::pair<Spectrum, Spectrum> min_max_;
};

// Reads the first image of any file that OpenImageIO knows. Texels keep the precision of the file: 8 bits,
// half or float; 16-bit integers become float. Values that are NaN, infinite or negative become 0; where
// there were any, a sentence that says how many is added to `repairs`. Throws SceneError if the file is
// missing, unreadable, truncated, empty or larger than 2²⁹ texels. What does not fit into `memory` stays in its file.
TextureImage load_texture_image(const std::string& path, ColorSpace color_space,
                                std::vector<std::string>& repairs, TextureMemory* memory = nullptr);

// The same of a file's bytes in memory. `name` is for messages, and its ending tells the format.
TextureImage load_texture_image(std::string_view bytes, const std::string& name, ColorSpace color_space,
                                std::vector<std::string>& repairs);

}  // namespace umbral
