// Interpolation of texels.
#include "image/texture_image.h"

#include <algorithm>

#include "image/mip_levels.h"

namespace umbral {
namespace {

std::array<float, 256> decoded_codes() {
  std::array<float, 256> codes;
  for (int i = 0; i < 256; ++i) codes[i] = srgb_decode(static_cast<float>(i) / 255);
  return codes;
}

// Both axes wrapped alike, known when compiled, so that each case is straight code without calls: 2.5 times as fast as a
// choice at each look-up, which EachWrap makes.
template <Wrap both>
struct SameWrap {
  static constexpr Wrap u = both, v = both;
};
struct EachWrap {
  Wrap u, v;
};

// Coordinates in texels, wrapped into the image; in [0, n], for any u.
inline float wrapped(float u, int n, Wrap wrap) {
  float t = std::min(u, 1.0f);
  if (wrap == Wrap::repeat)
    t = u - std::floor(u);
  else if (wrap == Wrap::mirror)
    t = 1 - std::abs(u - 2 * std::floor(0.5f * u) - 1);
  t = t > 0 ? t : 0;  // and not a number becomes 0
  return t * static_cast<float>(n);
}

// The two texels beside a coordinate, and how far it is from the first to the second.
struct Neighbours {
  int first, second;
  float fraction;
};

inline Neighbours neighbours(float u, int n, Wrap wrap) {
  const float x = wrapped(u, n, wrap) + 0.5f;
  const int second = static_cast<int>(x);  // x > 0: rounds down
  const float fraction = x - static_cast<float>(second);
  if (wrap == Wrap::repeat)
    return {second == 0 ? n - 1 : second - 1, second == n ? 0 : second, fraction};
  else
    return {std::max(second - 1, 0), std::min(second, n - 1), fraction};
}

// A random number in [0, 1) that is used up decision by decision.
class Chance {
 public:
  explicit Chance(std::uint32_t random) : u_(static_cast<float>(random >> 8) * 0x1p-24f) {}

  // True with that probability; what is left of u is as random as before.
  bool decides(float probability) {
    const bool yes = u_ < probability;
    u_ = yes ? u_ / probability : (u_ - probability) / (1 - probability);
    return yes;
  }

 private:
  float u_;
};

// One of the four texels that interpolated() joins, with the probability of its weight.
template <class Pair>
Spectrum chosen_texel(const TextureImage::Texels& texels, const Vec2& uv, Pair wraps, Chance& chance) {
  return std::visit(
      [&](const auto& grid) {
        const Neighbours x = neighbours(uv.x, grid.width(), wraps.u),
                         y = neighbours(uv.y, grid.height(), wraps.v);
        const int column = chance.decides(x.fraction) ? x.second : x.first;
        const int row = chance.decides(y.fraction) ? y.second : y.first;
        return grid.at(column, row);
      },
      texels);
}

template <class Pair>
Spectrum interpolated(const TextureImage::Texels& texels, const Vec2& uv, Pair wraps) {
  return std::visit(
      [&](const auto& grid) {
        const Neighbours x = neighbours(uv.x, grid.width(), wraps.u),
                         y = neighbours(uv.y, grid.height(), wraps.v);
        const Spectrum bottom = mix(grid.at(x.first, y.first), grid.at(x.second, y.first), x.fraction);
        const Spectrum top = mix(grid.at(x.first, y.second), grid.at(x.second, y.second), x.fraction);
        return mix(bottom, top, y.fraction);
      },
      texels);
}

bool outside(const Vec2& uv, Wraps wraps) {
  return (wraps.u == Wrap::none && (uv.x < 0 || uv.x > 1)) ||
         (wraps.v == Wrap::none && (uv.y < 0 || uv.y > 1));
}

// Calls look_up with the wraps, as types where both axes have the same.
template <class LookUp>
Spectrum with_wraps(const Vec2& uv, Wraps wraps, const LookUp& look_up) {
  if (wraps.u != wraps.v) return outside(uv, wraps) ? Spectrum(0.0f) : look_up(EachWrap{wraps.u, wraps.v});
  switch (wraps.u) {
    case Wrap::repeat:
      return look_up(SameWrap<Wrap::repeat>{});
    case Wrap::mirror:
      return look_up(SameWrap<Wrap::mirror>{});
    case Wrap::clamp:
      return look_up(SameWrap<Wrap::clamp>{});
    case Wrap::none:
      break;
  }
  return outside(uv, wraps) ? Spectrum(0.0f) : look_up(SameWrap<Wrap::clamp>{});
}

template <class Grid>
std::pair<Spectrum, Spectrum> range_of(const Grid& grid) {
  if constexpr (requires { grid.range(); }) return grid.range();
  std::pair<Spectrum, Spectrum> range{grid.at(0, 0), grid.at(0, 0)};
  for (int y = 0; y < grid.height(); ++y)
    for (int x = 0; x < grid.width(); ++x) {
      const Spectrum texel = grid.at(x, y);
      range = {min(range.first, texel), max(range.second, texel)};
    }
  return range;
}

Spectrum interpolated(const TextureImage::Texels& texels, const Vec2& uv, Wraps wraps) {
  return with_wraps(uv, wraps, [&](auto pair) { return interpolated(texels, uv, pair); });
}

}  // namespace

const std::array<float, 256> srgb_codes = decoded_codes();

TextureImage::TextureImage(Texels texels)
    : texels_(std::move(texels)),
      width_(std::visit([](const auto& grid) { return grid.width(); }, texels_)),
      height_(std::visit([](const auto& grid) { return grid.height(); }, texels_)),
      min_max_(std::visit([](const auto& grid) { return range_of(grid); }, texels_)) {}

Spectrum TextureImage::bilinear(const Vec2& uv, Wraps wraps) const {
  return interpolated(texels_, uv, wraps);
}

void TextureImage::build_levels() {
  if (levels_.empty()) levels_ = mip_levels(texels_);
}

// Level λ = log₂(width), between two levels by its fraction.
Spectrum TextureImage::filtered(const Vec2& uv, Wraps wraps, bool by_level,
                                const TextureFootprint& footprint) const {
  Chance chance(footprint.random);
  float lambda = by_level && footprint.width > 1 ? std::log2(footprint.width) : 0;
  lambda = std::min(lambda, static_cast<float>(levels_.size()));
  const auto below = static_cast<std::size_t>(lambda);
  const float fraction = lambda - static_cast<float>(below);
  const auto level = [&](std::size_t i) -> const Texels& { return i == 0 ? texels_ : levels_[i - 1]; };
  if (footprint.random == 0) {
    const Spectrum finer = interpolated(level(below), uv, wraps);
    return fraction > 0 ? mix(finer, interpolated(level(below + 1), uv, wraps), fraction) : finer;
  }
  const std::size_t chosen = fraction > 0 && chance.decides(fraction) ? below + 1 : below;
  return with_wraps(uv, wraps, [&](auto pair) { return chosen_texel(level(chosen), uv, pair, chance); });
}

Spectrum TextureImage::nearest(const Vec2& uv, Wraps wraps) const {
  return with_wraps(uv, wraps, [&](auto pair) {
    const int x = std::min(static_cast<int>(wrapped(uv.x, width(), pair.u)), width() - 1);
    const int y = std::min(static_cast<int>(wrapped(uv.y, height(), pair.v)), height() - 1);
    return texel(x, y);
  });
}

std::size_t TextureImage::memory() const {
  const auto of = [](const Texels& texels) {
    return std::visit([](const auto& grid) { return grid.memory(); }, texels);
  };
  std::size_t sum = of(texels_);
  for (const Texels& level : levels_) sum += of(level);
  return sum;
}

}  // namespace umbral
