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

// Coordinates in texels, wrapped into the image; in [0, n], for any u.
template <Wrap wrap>
float wrapped(float u, int n) {
  float t;
  if constexpr (wrap == Wrap::repeat)
    t = u - std::floor(u);
  else if constexpr (wrap == Wrap::mirror)
    t = 1 - std::abs(u - 2 * std::floor(0.5f * u) - 1);
  else
    t = std::min(u, 1.0f);
  t = t > 0 ? t : 0;  // and not a number becomes 0
  return t * static_cast<float>(n);
}

// The two texels beside a coordinate, and how far it is from the first to the second.
struct Neighbours {
  int first, second;
  float fraction;
};

template <Wrap wrap>
Neighbours neighbours(float u, int n) {
  const float x = wrapped<wrap>(u, n) + 0.5f;
  const int second = static_cast<int>(x);  // x > 0: rounds down
  const float fraction = x - static_cast<float>(second);
  if constexpr (wrap == Wrap::repeat)
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
template <Wrap wrap>
Spectrum chosen_texel(const TextureImage::Texels& texels, const Vec2& uv, Chance& chance) {
  return std::visit(
      [&](const auto& grid) {
        const Neighbours x = neighbours<wrap>(uv.x, grid.width()), y = neighbours<wrap>(uv.y, grid.height());
        const int column = chance.decides(x.fraction) ? x.second : x.first;
        const int row = chance.decides(y.fraction) ? y.second : y.first;
        return grid.at(column, row);
      },
      texels);
}

template <Wrap wrap>
Spectrum interpolated(const TextureImage::Texels& texels, const Vec2& uv) {
  return std::visit(
      [&](const auto& grid) {
        const Neighbours x = neighbours<wrap>(uv.x, grid.width()), y = neighbours<wrap>(uv.y, grid.height());
        const Spectrum bottom = mix(grid.at(x.first, y.first), grid.at(x.second, y.first), x.fraction);
        const Spectrum top = mix(grid.at(x.first, y.second), grid.at(x.second, y.second), x.fraction);
        return mix(bottom, top, y.fraction);
      },
      texels);
}

template <Wrap wrap>
Spectrum nearest_texel(const TextureImage& image, const Vec2& uv) {
  const int x = std::min(static_cast<int>(wrapped<wrap>(uv.x, image.width())), image.width() - 1);
  const int y = std::min(static_cast<int>(wrapped<wrap>(uv.y, image.height())), image.height() - 1);
  return image.texel(x, y);
}

bool outside(const Vec2& uv) { return uv.x < 0 || uv.x > 1 || uv.y < 0 || uv.y > 1; }

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

// The switch is outside, once for both axes, so that each case is straight code without calls: 2.5 times as
// fast.
Spectrum interpolated(const TextureImage::Texels& texels, const Vec2& uv, Wrap wrap) {
  switch (wrap) {
    case Wrap::repeat:
      return interpolated<Wrap::repeat>(texels, uv);
    case Wrap::mirror:
      return interpolated<Wrap::mirror>(texels, uv);
    case Wrap::clamp:
      return interpolated<Wrap::clamp>(texels, uv);
    case Wrap::none:
      break;
  }
  return outside(uv) ? Spectrum(0.0f) : interpolated<Wrap::clamp>(texels, uv);
}

Spectrum chosen_texel(const TextureImage::Texels& texels, const Vec2& uv, Wrap wrap, Chance& chance) {
  switch (wrap) {
    case Wrap::repeat:
      return chosen_texel<Wrap::repeat>(texels, uv, chance);
    case Wrap::mirror:
      return chosen_texel<Wrap::mirror>(texels, uv, chance);
    case Wrap::clamp:
      return chosen_texel<Wrap::clamp>(texels, uv, chance);
    case Wrap::none:
      break;
  }
  return outside(uv) ? Spectrum(0.0f) : chosen_texel<Wrap::clamp>(texels, uv, chance);
}

}  // namespace

const std::array<float, 256> srgb_codes = decoded_codes();

TextureImage::TextureImage(Texels texels)
    : texels_(std::move(texels)),
      width_(std::visit([](const auto& grid) { return grid.width(); }, texels_)),
      height_(std::visit([](const auto& grid) { return grid.height(); }, texels_)),
      min_max_(std::visit([](const auto& grid) { return range_of(grid); }, texels_)) {}

Spectrum TextureImage::bilinear(const Vec2& uv, Wrap wrap) const { return interpolated(texels_, uv, wrap); }

void TextureImage::build_levels() {
  if (levels_.empty()) levels_ = mip_levels(texels_);
}

// Level λ = log₂(width), between two levels by its fraction.
Spectrum TextureImage::filtered(const Vec2& uv, Wrap wrap, bool by_level,
                                const TextureFootprint& footprint) const {
  Chance chance(footprint.random);
  float lambda = by_level && footprint.width > 1 ? std::log2(footprint.width) : 0;
  lambda = std::min(lambda, static_cast<float>(levels_.size()));
  const auto below = static_cast<std::size_t>(lambda);
  const float fraction = lambda - static_cast<float>(below);
  const auto level = [&](std::size_t i) -> const Texels& { return i == 0 ? texels_ : levels_[i - 1]; };
  if (footprint.random == 0) {
    const Spectrum finer = interpolated(level(below), uv, wrap);
    return fraction > 0 ? mix(finer, interpolated(level(below + 1), uv, wrap), fraction) : finer;
  }
  const std::size_t chosen = fraction > 0 && chance.decides(fraction) ? below + 1 : below;
  return chosen_texel(level(chosen), uv, wrap, chance);
}

Spectrum TextureImage::nearest(const Vec2& uv, Wrap wrap) const {
  switch (wrap) {
    case Wrap::repeat:
      return nearest_texel<Wrap::repeat>(*this, uv);
    case Wrap::mirror:
      return nearest_texel<Wrap::mirror>(*this, uv);
    case Wrap::clamp:
      return nearest_texel<Wrap::clamp>(*this, uv);
    case Wrap::none:
      break;
  }
  return outside(uv) ? Spectrum(0.0f) : nearest_texel<Wrap::clamp>(*this, uv);
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
