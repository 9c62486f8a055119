// Levels of detail and stochastic filters, against sums in double and an analytic checker.
#include <cmath>
#include <random>

#include <gtest/gtest.h>

#include "image/mip_levels.h"
#include "image/texture_image.h"

namespace umbral {
namespace {

using Vec4d = glm::dvec4;

template <class Format, class Of>
TexelGrid<Format> grid_of(int width, int height, const Of& of) {
  TexelGrid<Format> grid(width, height);
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) grid.set(x, y, of(x, y));
  return grid;
}

Spectrum random_texel(int x, int y) {
  std::mt19937 random(static_cast<unsigned>(1000 * y + x));
  std::uniform_real_distribution<float> uniform;
  return {uniform(random), uniform(random), uniform(random), uniform(random)};
}

// Of `squares` × `squares` squares, 0 and 1.
TextureImage checker(int size, int squares) {
  const int side = size / squares;
  return TextureImage(TextureImage::Texels(grid_of<Float4>(
      size, size, [&](int x, int y) { return Spectrum((x / side + y / side) % 2 == 0 ? 0.0f : 1.0f); })));
}

Vec4d mean(const TextureImage::Texels& texels) {
  return std::visit(
      [](const auto& grid) {
        Vec4d sum(0);
        for (int y = 0; y < grid.height(); ++y)
          for (int x = 0; x < grid.width(); ++x) sum += Vec4d(grid.at(x, y));
        return sum / static_cast<double>(grid.width()) / static_cast<double>(grid.height());
      },
      texels);
}

int width_of(const TextureImage::Texels& texels) {
  return std::visit([](const auto& grid) { return grid.width(); }, texels);
}

// Over even parts of the random number's range, so that nothing is left to chance but the filter's decisions.
Vec4d mean_of_look_ups(const TextureImage& image, const Vec2& uv, Wrap wrap, TextureFilter filter,
                       float width) {
  constexpr int parts = 1 << 14;
  Vec4d sum(0);
  for (int i = 0; i < parts; ++i) {
    const auto random = static_cast<std::uint32_t>((static_cast<std::uint64_t>(i) << 18) + (1u << 17));
    sum += Vec4d(image.lookup(uv, wrap, filter, {width, random}));
  }
  return sum / double{parts};
}

TEST(MipLevels, HalveDownToOneTexelOfTheSameMean) {
  for (const auto& [width, height] :
       {std::pair(64, 64), std::pair(37, 23), std::pair(5, 1), std::pair(1, 7)}) {
    const TextureImage::Texels finest = grid_of<Float4>(width, height, random_texel);
    const auto levels = mip_levels(finest);
    ASSERT_FALSE(levels.empty());
    int expected = width;
    for (const auto& level : levels) {
      expected = std::max(1, expected / 2);
      EXPECT_EQ(width_of(level), expected);
      EXPECT_LT(glm::length(mean(level) - mean(finest)), 1e-5) << width << " x " << height;
    }
    EXPECT_EQ(width_of(levels.back()), 1);
  }
  EXPECT_TRUE(mip_levels(grid_of<Float4>(1, 1, random_texel)).empty());
}

// Codes of sRGB are averaged as light, and stored as codes again: half black, half white is code 188.
TEST(MipLevels, AverageLightAndNotCodes) {
  const TextureImage::Texels finest = grid_of<Srgb8>(2, 2, [](int x, int) {
    const auto code = static_cast<std::uint8_t>(x == 0 ? 0 : 255);
    return Srgb8::Stored{code, code, code, code};
  });
  const auto levels = mip_levels(finest);
  ASSERT_EQ(levels.size(), 1u);
  const Spectrum texel = std::get<TexelGrid<Srgb8>>(levels[0]).at(0, 0);
  EXPECT_FLOAT_EQ(texel.r, srgb_decode(188 / 255.0f));
  EXPECT_NEAR(texel.a, 0.5f, 0.51f / 255);
}

TEST(MipLevels, KeepTheFormatOfTheFile) {
  const auto of = [](int x, int y) { return Half4::encoded(random_texel(x, y)); };
  const TextureImage::Texels finest = grid_of<Half4>(8, 8, of);
  for (const auto& level : mip_levels(finest)) {
    EXPECT_TRUE(std::holds_alternative<TexelGrid<Half4>>(level));
    EXPECT_LT(glm::length(mean(level) - mean(finest)), 1e-3);
  }
}

TEST(StochasticFilter, HasTheMeanOfBilinear) {
  const TextureImage image(TextureImage::Texels(grid_of<Float4>(7, 5, random_texel)));
  std::mt19937 random(1);
  std::uniform_real_distribution<float> uniform(-1, 2);
  for (const Wrap wrap : {Wrap::repeat, Wrap::mirror, Wrap::clamp, Wrap::none})
    for (int i = 0; i < 20; ++i) {
      const float u = uniform(random);
      const Vec2 uv{u, uniform(random)};
      const Vec4d expected(image.bilinear(uv, wrap));
      EXPECT_LT(glm::length(mean_of_look_ups(image, uv, wrap, TextureFilter::stochastic, 0) - expected),
                1e-3);
      EXPECT_EQ(image.lookup(uv, wrap, TextureFilter::stochastic), image.bilinear(uv, wrap))
          << "without a number";
    }
}

// At every level and between: the mean is what interpolating both levels and between them gives.
TEST(MipFilter, HasTheMeanOfTrilinear) {
  TextureImage image(TextureImage::Texels(grid_of<Float4>(32, 32, random_texel)));
  image.build_levels();
  EXPECT_EQ(image.level_count(), 6);
  std::mt19937 random(2);
  std::uniform_real_distribution<float> uniform;
  for (const float width : {0.0f, 0.7f, 1.0f, 1.5f, 2.0f, 5.0f, 11.0f, 32.0f, 1000.0f})
    for (int i = 0; i < 5; ++i) {
      const float u = uniform(random);
      const Vec2 uv{u, uniform(random)};
      const Vec4d expected(image.lookup(uv, Wrap::repeat, TextureFilter::mip, {width, 0}));
      EXPECT_LT(glm::length(mean_of_look_ups(image, uv, Wrap::repeat, TextureFilter::mip, width) - expected),
                2e-3)
          << width;
      if (width <= 1) {
        EXPECT_EQ(Spectrum(expected), image.bilinear(uv, Wrap::repeat));
      }
    }
}

// Against the mean over the square of that width by brute force: alike where the square lies in one colour or covers
// whole periods; at edges the filter, which is a few tents and not a box, errs by no more than a sixth.
TEST(MipFilter, IsTheMeanOverItsWidthOfAChecker) {
  TextureImage image = checker(256, 8);
  image.build_levels();
  const auto brute_force = [&](const Vec2& uv, float width) {
    double sum = 0;
    constexpr int parts = 64;
    for (int j = 0; j < parts; ++j)
      for (int i = 0; i < parts; ++i) {
        const Vec2 offset = Vec2((Vec2(i, j) + 0.5f) / static_cast<float>(parts) - 0.5f) * width;
        const Vec2 at = glm::floor((uv + offset / 256.0f) * 8.0f);
        sum += std::fmod(at.x + at.y + 16, 2.0f) == 0 ? 0 : 1;
      }
    return sum / (parts * parts);
  };
  std::mt19937 random(3);
  std::uniform_real_distribution<float> uniform;
  for (const float width : {2.0f, 4.0f, 8.0f}) {
    double worst = 0, bias = 0;
    constexpr int points = 400;
    for (int i = 0; i < points; ++i) {
      const float u = uniform(random);
      const Vec2 uv{u, uniform(random)};
      const double error =
          static_cast<double>(image.lookup(uv, Wrap::repeat, TextureFilter::mip, {width, 0}).r) -
          brute_force(uv, width);
      worst = std::max(worst, std::abs(error));
      bias += error / points;
    }
    EXPECT_LT(worst, 0.17 + 0.02 * static_cast<double>(width)) << width;
    EXPECT_LT(std::abs(bias), 0.01) << width;
    const Vec2 middle(1.5f / 8, 1.5f / 8);
    EXPECT_NEAR(image.lookup(middle, Wrap::repeat, TextureFilter::mip, {width, 0}).r, 0, 1e-6) << width;
  }
  EXPECT_NEAR(image.lookup({0.3f, 0.4f}, Wrap::repeat, TextureFilter::mip, {128, 0}).r, 0.5f, 1e-6);
}

}  // namespace
}  // namespace umbral
