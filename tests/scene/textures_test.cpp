// Textures: how uv is placed, what they evaluate to, and bounds that hold for all of it.
#include "scene/textures/textures.h"

#include <gtest/gtest.h>

#include "support/random.h"

namespace umbral {
namespace {

using test::Random;

std::shared_ptr<const TextureImage> image_of(int width, int height, const std::vector<Spectrum>& rows) {
  TexelGrid<Float4> grid(width, height);
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) grid.set(x, y, rows[static_cast<std::size_t>(y * width + x)]);
  return std::make_shared<TextureImage>(TextureImage::Texels(std::move(grid)));
}

Texture prepared(TextureKinds kind) {
  Texture texture{"", std::move(kind)};
  texture.prepare();
  return texture;
}

void expect_near(const Vec2& a, const Vec2& b) {
  EXPECT_NEAR(a.x, b.x, 1e-6);
  EXPECT_NEAR(a.y, b.y, 1e-6);
}

TEST(UvMap, ScalesThenRotatesThenOffsets) {
  expect_near(UvMap()({0.3f, 0.7f}), {0.3f, 0.7f});
  expect_near(UvMap({{2, 3}, 0, {0, 0}})({1, 1}), {2, 3});
  expect_near(UvMap({{1, 1}, 90, {0, 0}})({1, 0}), {0, 1});
  expect_near(UvMap({{2, 3}, 90, {10, 20}})({1, 1}), {10 - 3, 20 + 2});
  expect_near(UvMap({{1, 1}, 30, {0, 0}})({1, 0}), {std::sqrt(3.0f) / 2, 0.5f});
}

TEST(CheckerTexture, AlternatesOnBothSidesOfTheOrigin) {
  CheckerTexture checker;
  checker.even = rgb(1, 0, 0);
  checker.odd = rgb(0, 0, 1);
  checker.uv_scale = {1, 1};
  const Texture texture = prepared(checker);
  for (int x = -5; x <= 5; ++x)
    for (int y = -5; y <= 5; ++y) {
      const Vec2 uv{static_cast<float>(x) + 0.25f, static_cast<float>(y) + 0.75f};
      EXPECT_EQ(texture.color(uv), (x + y) % 2 == 0 ? checker.even : checker.odd) << x << ", " << y;
    }
}

TEST(CheckerTexture, HasAsManySquaresAsItsScale) {
  CheckerTexture checker;
  checker.uv_scale = {4, 2};
  const Texture texture = prepared(checker);
  int changes = 0;
  for (int i = 2; i < 1000; ++i) {
    const float u = static_cast<float>(i) / 1000, before = static_cast<float>(i - 1) / 1000;
    changes += texture.color({u, 0.1f}) != texture.color({before, 0.1f});
  }
  EXPECT_EQ(changes, 3);
  EXPECT_EQ(texture.color({0.01f, 0.01f}), checker.even);
  EXPECT_EQ(texture.color({0.01f, 0.51f}), checker.odd);
}

TEST(ImageTexture, GivesTexelsTimesFactorPlusBias) {
  ImageTexture image;
  image.image = image_of(2, 2, {{0.1f, 0.2f, 0.3f, 1}, {0.4f, 0.5f, 0.6f, 0.5f}, {0, 0, 0, 0}, {1, 1, 1, 1}});
  image.filter = TextureFilter::nearest;
  image.factor = 2;
  image.bias = -0.1f;
  const Texture texture = prepared(image);
  const Spectrum first = texture.color({0.25f, 0.25f}), second = texture.color({0.75f, 0.25f});
  for (int c = 0; c < 3; ++c) {
    EXPECT_NEAR(first[c], 2 * (0.1 + 0.1 * c) - 0.1, 1e-6);
    EXPECT_NEAR(second[c], 2 * (0.4 + 0.1 * c) - 0.1, 1e-6);
  }
}

TEST(ImageTexture, GivesTheChosenChannelToParametersThatAreNumbers) {
  ImageTexture image;
  image.image = image_of(1, 1, {{0.1f, 0.2f, 0.3f, 0.4f}});
  const auto number = [&](TextureChannel channel) {
    image.channel = channel;
    return prepared(image).number({0.5f, 0.5f});
  };
  EXPECT_FLOAT_EQ(number(TextureChannel::r), 0.1f);
  EXPECT_FLOAT_EQ(number(TextureChannel::g), 0.2f);
  EXPECT_FLOAT_EQ(number(TextureChannel::b), 0.3f);
  EXPECT_FLOAT_EQ(number(TextureChannel::a), 0.4f);
  EXPECT_FLOAT_EQ(number(TextureChannel::luminance), 0.2126f * 0.1f + 0.7152f * 0.2f + 0.0722f * 0.3f);
}

TEST(ImageTexture, RepeatsAsItIsScaledAndMovesByItsOffset) {
  ImageTexture image;
  image.image = image_of(2, 1, {grey(0), grey(1)});
  image.filter = TextureFilter::nearest;
  image.uv_scale = {3, 1};
  const Texture texture = prepared(image);
  for (int i = 0; i < 12; ++i) {
    const float u = (static_cast<float>(i) + 0.5f) / 6;
    EXPECT_EQ(texture.color({u, 0.5f}).r, static_cast<float>(i % 2)) << i;
  }
  image.uv_offset = {0.5f, 0};
  EXPECT_EQ(prepared(image).color({0.5f / 6, 0.5f}).r, 1);
}

// A reader trusts the bounds to keep a parameter in its range, so no look-up anywhere may leave them.
TEST(Textures, StayWithinTheirBounds) {
  Random random(1);
  for (int i = 0; i < 300; ++i) {
    std::vector<Spectrum> texels;
    for (int k = 0; k < 12; ++k)
      texels.emplace_back(0.2 + random.number(), 0.2 + random.number(), 0.2 + random.number(),
                          0.2 + random.number());
    ImageTexture image;
    image.image = image_of(4, 3, texels);
    image.wrap = static_cast<Wrap>(i % 4);
    image.filter = random.coin() ? TextureFilter::bilinear : TextureFilter::nearest;
    image.factor = static_cast<float>(random.between(-2, 2));
    image.bias = static_cast<float>(random.between(-1, 1));
    image.channel = static_cast<TextureChannel>(i % 5);
    image.uv_scale = Vec2(random.between(-3, 3), random.between(-3, 3));
    image.uv_rotation = static_cast<float>(random.between(0, 360));
    CheckerTexture checker;
    checker.even = Spectrum(Vec3(random.in_cube(1)), 0);
    checker.odd = Spectrum(Vec3(random.in_cube(1)), 0);
    for (const Texture& texture : {prepared(image), prepared(checker)}) {
      const TextureBounds bounds = texture.color_bounds();
      const Range range = texture.number_bounds();
      for (int k = 0; k < 200; ++k) {
        const Vec2 uv(random.between(-2, 3), random.between(-2, 3));
        const Spectrum color = texture.color(uv);
        for (int c = 0; c < 4; ++c) {
          EXPECT_GE(color[c], bounds.low[c] - 1e-6f) << "wrap " << i % 4;
          EXPECT_LE(color[c], bounds.high[c] + 1e-6f) << "wrap " << i % 4;
        }
        EXPECT_GE(texture.number(uv), range.low - 1e-6f);
        EXPECT_LE(texture.number(uv), range.high + 1e-6f);
      }
    }
  }
}

}  // namespace
}  // namespace umbral
