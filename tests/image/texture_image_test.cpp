// Interpolation of texels against the definition, in double, texel by texel.
#include "image/texture_image.h"

#include <cmath>
#include <limits>
#include <random>

#include <gtest/gtest.h>

namespace umbral {
namespace {

using Vec4d = glm::dvec4;
constexpr Wrap wraps[] = {Wrap::repeat, Wrap::mirror, Wrap::clamp, Wrap::none};

TextureImage random_texture(int width, int height) {
  TexelGrid<Float4> grid(width, height);
  std::mt19937 random(3);
  std::uniform_real_distribution<float> uniform;
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) {
      Spectrum texel;
      for (int c = 0; c < 4; ++c) texel[c] = uniform(random);
      grid.set(x, y, texel);
    }
  return TextureImage{std::move(grid)};
}

// The index of a texel that an endless image has at i.
int wrapped_index(int i, int n, Wrap wrap) {
  const auto modulo = [](int a, int b) { return ((a % b) + b) % b; };
  if (wrap == Wrap::repeat) return modulo(i, n);
  if (wrap == Wrap::mirror) return modulo(i, 2 * n) < n ? modulo(i, 2 * n) : 2 * n - 1 - modulo(i, 2 * n);
  return std::clamp(i, 0, n - 1);
}

Vec4d reference(const TextureImage& image, const Vec2& uv, Wrap wrap) {
  if (wrap == Wrap::none && (uv.x < 0 || uv.x > 1 || uv.y < 0 || uv.y > 1)) return Vec4d(0);
  const double x = double{uv.x} * image.width() - 0.5, y = double{uv.y} * image.height() - 0.5;
  const int i = static_cast<int>(std::floor(x)), j = static_cast<int>(std::floor(y));
  Vec4d sum(0);
  for (int b = 0; b < 2; ++b)
    for (int a = 0; a < 2; ++a) {
      const double weight = (a ? x - i : 1 - (x - i)) * (b ? y - j : 1 - (y - j));
      const int column = wrapped_index(i + a, image.width(), wrap),
                row = wrapped_index(j + b, image.height(), wrap);
      sum += weight * Vec4d(image.texel(column, row));
    }
  return sum;
}

TEST(TextureImage, BilinearFollowsTheDefinition) {
  std::mt19937 random(5);
  std::uniform_real_distribution<float> uniform(-3, 4);
  for (const auto& [width, height] : {std::pair{1, 1}, {2, 1}, {5, 7}, {64, 33}}) {
    const TextureImage image = random_texture(width, height);
    for (const Wrap wrap : wraps)
      for (int i = 0; i < 20'000; ++i) {
        const Vec2 uv{uniform(random), uniform(random)};
        const Vec4d expected = reference(image, uv, wrap);
        const Spectrum found = image.bilinear(uv, wrap);
        // A coordinate near 4 is rounded by 2.4e-7, and so is its fraction of the image: that times its size.
        for (int c = 0; c < 4; ++c) ASSERT_NEAR(found[c], expected[c], 2.4e-7 * 2 * (width + height) + 1e-6);
      }
  }
}

TEST(TextureImage, TexelCentresAreExact) {
  const TextureImage image = random_texture(16, 8);
  for (const Wrap wrap : wraps)
    for (int y = 0; y < 8; ++y)
      for (int x = 0; x < 16; ++x) {
        const Vec2 uv{(static_cast<float>(x) + 0.5f) / 16, (static_cast<float>(y) + 0.5f) / 8};
        EXPECT_EQ(image.bilinear(uv, wrap), image.texel(x, y));
        EXPECT_EQ(image.nearest(uv, wrap), image.texel(x, y));
      }
}

// A checker of powers of two looked up with `nearest`: exactly 0 or 1, and which of the two by arithmetic.
TEST(TextureImage, NearestOfACheckerIsExact) {
  TexelGrid<Linear8> grid(8, 8);
  for (int y = 0; y < 8; ++y)
    for (int x = 0; x < 8; ++x) {
      const auto value = static_cast<std::uint8_t>((x + y) % 2 ? 255 : 0);
      grid.set(x, y, {value, value, value, 255});
    }
  const TextureImage image{std::move(grid)};
  std::mt19937 random(6);
  std::uniform_real_distribution<float> uniform(-2, 2);
  for (int i = 0; i < 50'000; ++i) {
    const Vec2 uv{uniform(random), uniform(random)};
    const int parity = static_cast<int>(std::floor(8 * uv.x) + std::floor(8 * uv.y)) & 1;
    ASSERT_EQ(image.nearest(uv, Wrap::repeat).r, parity) << uv.x << ' ' << uv.y;
  }
}

TEST(TextureImage, NearestMirrorsAndClamps) {
  const TextureImage image = random_texture(4, 4);
  const auto at = [&](float u, Wrap wrap) { return image.nearest({u, 0.125f}, wrap); };
  EXPECT_EQ(at(1.125f, Wrap::mirror), image.texel(3, 0));
  EXPECT_EQ(at(-0.125f, Wrap::mirror), image.texel(0, 0));
  EXPECT_EQ(at(-0.375f, Wrap::mirror), image.texel(1, 0));
  EXPECT_EQ(at(2.375f, Wrap::mirror), image.texel(1, 0));
  EXPECT_EQ(at(7, Wrap::clamp), image.texel(3, 0));
  EXPECT_EQ(at(-7, Wrap::clamp), image.texel(0, 0));
  EXPECT_EQ(at(1.001f, Wrap::none), Spectrum(0.0f));
  EXPECT_EQ(at(1, Wrap::none), image.texel(3, 0));
}

// Each axis as an image that wraps both that way.
TEST(TextureImage, AxesWrapEachInTheirOwnWay) {
  const TextureImage image = random_texture(4, 3);
  const auto alone = [](float u, Wrap wrap) {  // the place in the unit interval that it stands for
    if (wrap == Wrap::repeat) return u - std::floor(u);
    if (wrap == Wrap::mirror) return 1 - std::abs(u - 2 * std::floor(u / 2) - 1);
    return glm::clamp(u, 0.0f, 1.0f);
  };
  for (const Wrap across : {Wrap::repeat, Wrap::mirror, Wrap::clamp})
    for (const Wrap up : {Wrap::repeat, Wrap::mirror, Wrap::clamp})
      for (const Vec2 uv : {Vec2(0.6f, 0.4f), Vec2(-0.3f, 1.45f), Vec2(1.4f, -0.6f), Vec2(2.6f, 3.4f)}) {
        const Vec2 inside(alone(uv.x, across), alone(uv.y, up));
        EXPECT_EQ(image.nearest(uv, {across, up}), image.nearest(inside, Wrap::clamp));
        const Spectrum found = image.bilinear(uv, {across, up}),
                       expected = image.bilinear(inside, {across, up});
        for (int c = 0; c < 4; ++c) EXPECT_NEAR(found[c], expected[c], 1e-5f);
      }
  // Beyond the edge in u it repeats, in v it stays.
  const Spectrum seam = mix(image.texel(3, 2), image.texel(0, 2), 0.5f);
  for (int c = 0; c < 4; ++c)
    EXPECT_NEAR(image.bilinear({1, 5}, {Wrap::repeat, Wrap::clamp})[c], seam[c], 1e-6f);
  EXPECT_EQ(image.nearest({0.5f, 1.1f}, {Wrap::repeat, Wrap::none}), Spectrum(0.0f));
  EXPECT_EQ(image.nearest({1.1f, 0.5f}, {Wrap::repeat, Wrap::none}), image.texel(0, 1));
}

TEST(TextureImage, VPointsUp) {
  TexelGrid<Float4> grid(1, 2);
  grid.set(0, 0, rgb(1, 0, 0));
  grid.set(0, 1, rgb(0, 1, 0));
  const TextureImage image{std::move(grid)};
  EXPECT_EQ(image.nearest({0.5f, 0.1f}, Wrap::clamp), rgb(1, 0, 0));
  EXPECT_EQ(image.nearest({0.5f, 0.9f}, Wrap::clamp), rgb(0, 1, 0));
}

TEST(TextureImage, AnyCoordinateIsSafe) {
  const TextureImage image = random_texture(5, 3);
  const float nan = std::numeric_limits<float>::quiet_NaN();
  const float odd[] = {nan,
                       infinity,
                       -infinity,
                       3e38f,
                       -3e38f,
                       1e9f,
                       -1e9f,
                       16777215.5f,
                       1e-40f,
                       -1e-40f,
                       -1e-9f,
                       0.0f,
                       -0.0f,
                       1.0f,
                       one_minus_epsilon,
                       std::nextafter(1.0f, 2.0f)};
  const auto [low, high] = image.min_max();
  for (const Wrap wrap : wraps)
    for (const float u : odd)
      for (const float v : odd)
        for (const TextureFilter filter : {TextureFilter::bilinear, TextureFilter::nearest}) {
          const Spectrum found = image.lookup({u, v}, wrap, filter);
          for (int c = 0; c < 4; ++c) {
            EXPECT_GE(found[c], wrap == Wrap::none ? 0 : low[c]) << u << ' ' << v;
            EXPECT_LE(found[c], high[c]) << u << ' ' << v;
          }
        }
  EXPECT_EQ(image.nearest({nan, nan}, Wrap::repeat), image.texel(0, 0));
}

TEST(TextureImage, RepeatHasNoSeam) {
  const TextureImage image = random_texture(8, 8);
  const Spectrum inside = image.bilinear({one_minus_epsilon, 0.3f}, Wrap::repeat);
  for (const float u : {0.0f, 1.0f, -1e-9f, 5.0f})
    for (int c = 0; c < 4; ++c) EXPECT_NEAR(image.bilinear({u, 0.3f}, Wrap::repeat)[c], inside[c], 1e-5f);
}

TEST(Texels, EightBitFormatsDecodeEveryCode) {
  for (int i = 0; i < 256; ++i) {
    const auto code = static_cast<std::uint8_t>(i), inverse = static_cast<std::uint8_t>(255 - i);
    const Spectrum linear = Linear8::decoded({code, inverse, 0, 255});
    EXPECT_FLOAT_EQ(linear.r, static_cast<float>(i) / 255);
    EXPECT_FLOAT_EQ(linear.g, static_cast<float>(255 - i) / 255);
    EXPECT_EQ(linear.b, 0);
    EXPECT_EQ(linear.a, 1);
    const Spectrum decoded = Srgb8::decoded({code, inverse, 255, code});
    // IEC 61966-2-1, in double
    const double v = i / 255.0;
    EXPECT_NEAR(decoded.r, v <= 0.04045 ? v / 12.92 : std::pow((v + 0.055) / 1.055, 2.4), 2e-7);
    EXPECT_EQ(decoded.b, 1);
    EXPECT_FLOAT_EQ(decoded.a, static_cast<float>(i) / 255);
  }
}

TEST(Texels, HalvesDecodeInTheirOrder) {
  // 1, −2, 65504 (the largest) and 2⁻²⁴ (the smallest denormal)
  EXPECT_EQ(Half4::decoded(0x0001'7bff'c000'3c00), Spectrum(1, -2, 65504, 0x1p-24f));
}

TEST(Texels, EveryTexelHasItsOwnPlace) {
  for (const auto& [width, height] : {std::pair{1, 1}, {4, 4}, {5, 3}, {17, 9}}) {
    TexelGrid<Float4> grid(width, height);
    for (int y = 0; y < height; ++y)
      for (int x = 0; x < width; ++x) grid.set(x, y, grey(static_cast<float>(100 * y + x)));
    for (int y = 0; y < height; ++y)
      for (int x = 0; x < width; ++x) ASSERT_EQ(grid.at(x, y).r, static_cast<float>(100 * y + x));
  }
}

TEST(TextureImage, RangeAndAlpha) {
  TexelGrid<Float4> grid(3, 2);
  for (int y = 0; y < 2; ++y)
    for (int x = 0; x < 3; ++x) grid.set(x, y, {0.5f, static_cast<float>(x), 1 - static_cast<float>(y), 1});
  const TextureImage opaque{grid};
  EXPECT_EQ(opaque.min_max().first, Spectrum(0.5f, 0, 0, 1));
  EXPECT_EQ(opaque.min_max().second, Spectrum(0.5f, 2, 1, 1));
  EXPECT_FALSE(opaque.has_alpha());
  grid.set(1, 1, {0, 0, 0, 0.75f});
  EXPECT_TRUE(TextureImage{grid}.has_alpha());
  EXPECT_EQ(opaque.memory(), 16 * sizeof(Spectrum));
}

}  // namespace
}  // namespace umbral
