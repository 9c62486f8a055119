// Image files of all kinds as textures.
#include <cstring>
#include <limits>
#include <random>

#include "texture_kit.h"

namespace umbral {
namespace {

using test::four;
using test::put_bytes;
using test::TextureLoader;
using test::write_image;
using testing::HasSubstr;

TEST_F(TextureLoader, LosslessFormatsKeepEveryTexelAndTheTopRowIsOnTop) {
  for (const char* name : {"a.png", "a.tga", "a.bmp", "a.tif"}) {
    write_image(path(name), 2, 2, 3, OIIO::TypeDesc::UINT8, four);
    const TextureImage image = load(name, ColorSpace::linear);
    EXPECT_EQ(image.width(), 2) << name;
    EXPECT_EQ(image.texel(0, 1), Spectrum(1, 0, 0, 1)) << name;
    EXPECT_EQ(image.texel(1, 1), Spectrum(0, 1, 0, 1)) << name;
    EXPECT_EQ(image.texel(0, 0), Spectrum(0, 0, 1, 1)) << name;
    EXPECT_FLOAT_EQ(image.texel(1, 0).g, 20.0f / 255) << name;
    EXPECT_FALSE(image.has_alpha());
    EXPECT_EQ(image.memory(), 64u) << "8 bits stay 8 bits";
  }
  EXPECT_TRUE(repairs_.empty());
}

TEST_F(TextureLoader, IntegersAreSrgbUnlessStatedOtherwise) {
  write_image(path("a.png"), 2, 2, 3, OIIO::TypeDesc::UINT8, four);
  EXPECT_FLOAT_EQ(load("a.png").texel(1, 0).g, srgb_decode(20.0f / 255));
  EXPECT_FLOAT_EQ(load("a.png", ColorSpace::srgb).texel(1, 0).g, srgb_decode(20.0f / 255));
  EXPECT_FLOAT_EQ(load("a.png", ColorSpace::linear).texel(1, 0).g, 20.0f / 255);
}

TEST_F(TextureLoader, SixteenBitsKeepTheirDigits) {
  const std::vector<std::uint16_t> pixels{0, 1, 65535, 32768, 32769, 12345};
  write_image(path("a.png"), 2, 1, 3, OIIO::TypeDesc::UINT16, pixels);
  const TextureImage linear = load("a.png", ColorSpace::linear);
  EXPECT_FLOAT_EQ(linear.texel(0, 0).g, 1.0f / 65535);
  EXPECT_FLOAT_EQ(linear.texel(1, 0).g, 32769.0f / 65535);
  EXPECT_FLOAT_EQ(load("a.png").texel(1, 0).b, srgb_decode(12345.0f / 65535));
}

TEST_F(TextureLoader, FloatsAreLinearUnlessStatedOtherwise) {
  const std::vector<float> pixels{0.125f, 3.5f, 1e-6f, 100, 0, 0.5f};
  for (const char* name : {"a.exr", "a.tif", "a.hdr"}) {
    write_image(path(name), 2, 1, 3, OIIO::TypeDesc::FLOAT, pixels);
    const TextureImage image = load(name);
    EXPECT_NEAR(image.texel(0, 0).g, 3.5f, name == std::string("a.hdr") ? 0.02f : 0) << name;
    EXPECT_NEAR(image.texel(1, 0).r, 100, name == std::string("a.hdr") ? 0.5f : 0) << name;
  }
  EXPECT_FLOAT_EQ(load("a.exr", ColorSpace::srgb).texel(0, 0).r, srgb_decode(0.125f));
}

TEST_F(TextureLoader, HalvesStayHalves) {
  const std::vector<float> pixels{0.125f, 1000, 0.5f, 0.1f, 65504, 0x1p-24f};
  write_image(path("a.exr"), 2, 1, 3, OIIO::TypeDesc::HALF, pixels);
  const TextureImage image = load("a.exr");
  EXPECT_EQ(image.memory(), 16u * 8);
  EXPECT_EQ(image.texel(0, 0), Spectrum(0.125f, 1000, 0.5f, 1));
  EXPECT_NEAR(image.texel(1, 0).r, 0.1f, 0.1f * 0x1p-11f);
  EXPECT_EQ(image.texel(1, 0).g, 65504);
  EXPECT_EQ(image.texel(1, 0).b, 0x1p-24f);
  EXPECT_EQ(load("a.exr", ColorSpace::srgb).texel(0, 0).r, srgb_decode(0.125f));
}

TEST_F(TextureLoader, OneTwoAndFourChannels) {
  write_image<std::uint8_t>(path("grey.png"), 2, 1, 1, OIIO::TypeDesc::UINT8, {0, 51});
  const TextureImage grey_image = load("grey.png", ColorSpace::linear);
  EXPECT_FLOAT_EQ(grey_image.texel(1, 0).r, 0.2f);
  EXPECT_EQ(Vec3(grey_image.texel(1, 0)), Vec3(grey_image.texel(1, 0).r));
  EXPECT_EQ(grey_image.texel(1, 0).a, 1);

  write_image<std::uint8_t>(path("ya.png"), 2, 1, 2, OIIO::TypeDesc::UINT8, {51, 255, 102, 0});
  const TextureImage grey_alpha = load("ya.png", ColorSpace::linear);
  EXPECT_FLOAT_EQ(grey_alpha.texel(0, 0).g, 0.2f);
  EXPECT_EQ(grey_alpha.texel(0, 0).a, 1);
  EXPECT_FLOAT_EQ(grey_alpha.texel(1, 0).b, 0.4f);
  EXPECT_EQ(grey_alpha.texel(1, 0).a, 0);

  // Alpha is straight, linear even where colour is not, and does not darken the colour.
  write_image<std::uint8_t>(path("rgba.png"), 2, 1, 4, OIIO::TypeDesc::UINT8, {255, 51, 0, 51, 1, 2, 3, 255});
  const TextureImage colour_alpha = load("rgba.png");
  EXPECT_TRUE(colour_alpha.has_alpha());
  EXPECT_FLOAT_EQ(colour_alpha.texel(0, 0).r, 1);
  EXPECT_FLOAT_EQ(colour_alpha.texel(0, 0).g, srgb_decode(0.2f));
  EXPECT_FLOAT_EQ(colour_alpha.texel(0, 0).a, 0.2f);
  EXPECT_EQ(colour_alpha.texel(1, 0).a, 1);
}

TEST_F(TextureLoader, JpegIsCloseToItsPicture) {
  std::vector<std::uint8_t> pixels;
  for (int i = 0; i < 64 * 64; ++i) pixels.insert(pixels.end(), {200, 100, 50});
  write_image(path("a.jpg"), 64, 64, 3, OIIO::TypeDesc::UINT8, pixels);
  const Spectrum texel = load("a.jpg", ColorSpace::linear).texel(30, 30);
  EXPECT_NEAR(texel.r, 200 / 255.0f, 0.012f);
  EXPECT_NEAR(texel.g, 100 / 255.0f, 0.012f);
  EXPECT_NEAR(texel.b, 50 / 255.0f, 0.012f);
}

TEST_F(TextureLoader, BadValuesAreReplacedAndCounted) {
  const float nan = std::numeric_limits<float>::quiet_NaN();
  const std::vector<float> pixels{1, nan, 1, infinity, -infinity, 2, -1e-3f, 1, 1, 1, -0.0f, 1};
  write_image(path("a.exr"), 2, 2, 3, OIIO::TypeDesc::FLOAT, pixels);
  const TextureImage image = load("a.exr");
  EXPECT_EQ(image.texel(0, 1), Spectrum(1, 0, 1, 1));
  EXPECT_EQ(image.texel(1, 1), Spectrum(0, 0, 2, 1));
  EXPECT_EQ(image.texel(0, 0), Spectrum(0, 1, 1, 1));
  EXPECT_EQ(image.texel(1, 0), Spectrum(1, 0, 1, 1));
  ASSERT_EQ(repairs_.size(), 1u);
  EXPECT_EQ(repairs_[0], path("a.exr") +
                             ": 3 of 4 texels had values that are not a number, infinite or negative; "
                             "these values were replaced by 0");
  write_image(path("half.exr"), 2, 2, 3, OIIO::TypeDesc::HALF, pixels);
  const TextureImage half = load("half.exr");
  EXPECT_EQ(half.texel(0, 1), Spectrum(1, 0, 1, 1));
  EXPECT_EQ(half.texel(1, 1), Spectrum(0, 0, 2, 1));
  EXPECT_EQ(half.texel(0, 0), Spectrum(0, 1, 1, 1));
  ASSERT_EQ(repairs_.size(), 2u);
  EXPECT_THAT(repairs_[1], HasSubstr("3 of 4 texels"));
}

TEST_F(TextureLoader, ReadsTheFormatsOfTheField) {
  constexpr int side = 16;
  std::vector<float> pixels;  // smooth, as JPEG and RGBE want it
  for (int y = 0; y < side; ++y)
    for (int x = 0; x < side; ++x)
      for (const int value : {x, y, 8}) pixels.push_back(0.25f + 0.5f * static_cast<float>(value) / side);
  struct {
    const char* name;
    OIIO::TypeDesc type;
    float tolerance;
  } const formats[] = {{"a.png", OIIO::TypeDesc::UINT8, 0.003f}, {"a.jpg", OIIO::TypeDesc::UINT8, 0.03f},
                       {"a.tga", OIIO::TypeDesc::UINT8, 0.003f}, {"a.hdr", OIIO::TypeDesc::FLOAT, 0.01f},
                       {"a.exr", OIIO::TypeDesc::HALF, 0.001f},  {"b.exr", OIIO::TypeDesc::FLOAT, 0},
                       {"a.tif", OIIO::TypeDesc::UINT16, 1e-4f}};
  for (const auto& format : formats) {
    write_image(path(format.name), side, side, 3, format.type, pixels);
    const TextureImage image = load(format.name, ColorSpace::linear);
    ASSERT_EQ(image.width(), side) << format.name;
    for (int y = 0; y < side; ++y)
      for (int x = 0; x < side; ++x)
        for (int c = 0; c < 3; ++c)
          EXPECT_NEAR(image.texel(x, side - 1 - y)[c],
                      pixels[static_cast<std::size_t>(3 * (side * y + x) + c)], format.tolerance + 1e-6f)
              << format.name;
  }
}

std::string pfm(const std::string& header, const std::vector<float>& values, bool swapped = false) {
  std::string bytes = header;
  for (const float value : values) {
    char raw[4];
    std::memcpy(raw, &value, 4);
    if (swapped) std::reverse(raw, raw + 4);
    bytes.append(raw, 4);
  }
  return bytes;
}

TEST_F(TextureLoader, ReadsPfmOfBothByteOrdersGreyAndColoured) {
  put_bytes(path("a.pfm"), pfm("PF\n2 1\n-1.0\n", {0.25f, 0.5f, 1, 2, 3, 1000}));
  const TextureImage little = load("a.pfm");
  EXPECT_EQ(little.texel(0, 0), Spectrum(0.25f, 0.5f, 1, 1));
  EXPECT_EQ(little.texel(1, 0), Spectrum(2, 3, 1000, 1));
  put_bytes(path("b.PFM"), pfm("Pf 1 2 2.0\n", {0.25f, 4}, true));  // the first row is the lowest
  const TextureImage big = load("b.PFM");
  EXPECT_EQ(big.texel(0, 0), Spectrum(0.5f, 0.5f, 0.5f, 1));
  EXPECT_EQ(big.texel(0, 1), Spectrum(8, 8, 8, 1));
  put_bytes(path("c.pfm"), pfm("Pf\n1 1\n-1\n", {-3}));
  EXPECT_EQ(load("c.pfm").texel(0, 0).r, 0);
  EXPECT_EQ(repairs_.size(), 1u);
}

TEST_F(TextureLoader, ReadsWhatDoesNotFitTileByTile) {
  constexpr int width = 150, height = 70;
  std::mt19937 random(1);
  std::vector<std::uint8_t> codes(3 * width * height);
  for (auto& code : codes) code = static_cast<std::uint8_t>(random());
  std::vector<float> values(4 * width * height);
  for (auto& value : values)
    value = static_cast<float>(random() % 1000) / 500 - 0.1f;  // some of them negative
  write_image(path("a.png"), width, height, 3, OIIO::TypeDesc::UINT8, codes);
  write_image(path("b.exr"), width, height, 4, OIIO::TypeDesc::HALF, values);
  for (const char* name : {"a.png", "b.exr"})
    for (const ColorSpace space : {ColorSpace::srgb, ColorSpace::linear}) {
      const TextureImage whole = load(name, space);
      TextureMemory none(1000);
      const TextureImage cached = load_texture_image(path(name), space, repairs_, &none);
      EXPECT_EQ(cached.memory(), 0u);
      EXPECT_EQ(cached.width(), width);
      EXPECT_EQ(cached.is_srgb(), space == ColorSpace::srgb);
      for (int c = 0; c < 4; ++c) {
        EXPECT_NEAR(cached.min_max().first[c], whole.min_max().first[c], 1e-6);
        EXPECT_NEAR(cached.min_max().second[c], whole.min_max().second[c], 1e-6);
      }
      for (int i = 0; i < 2000; ++i) {
        const Vec2 uv{static_cast<float>(random() % 4096) / 2048, static_cast<float>(random() % 4096) / 4096};
        for (const Wrap wrap : {Wrap::repeat, Wrap::mirror, Wrap::none}) {
          const Spectrum a = whole.bilinear(uv, wrap), b = cached.bilinear(uv, wrap);
          for (int c = 0; c < 4; ++c) EXPECT_NEAR(a[c], b[c], 1e-6) << name;
        }
      }
    }
}

TEST_F(TextureLoader, FillsTheMemoryBeforeItLeavesImagesInTheirFiles) {
  write_image(path("a.png"), 2, 2, 3, OIIO::TypeDesc::UINT8, four);  // 16 bytes
  TextureMemory memory(40);                                          // 35 for whole images
  for (const bool fits : {true, true, false}) {
    const TextureImage image = load_texture_image(path("a.png"), ColorSpace::srgb, repairs_, &memory);
    EXPECT_EQ(image.memory() > 0, fits);
    EXPECT_EQ(image.texel(0, 1), Spectrum(1, 0, 0, 1));
  }
  EXPECT_EQ(memory.taken(), 32u);
}

}  // namespace
}  // namespace umbral
