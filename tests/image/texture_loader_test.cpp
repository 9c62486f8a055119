// Image files of all kinds, whole and broken.
#include <cmath>
#include <cstring>
#include <limits>
#include <random>

#include <OpenImageIO/imageio.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/error.h"
#include "files.h"
#include "image/texture_image.h"
#include "support/paths.h"

// OpenImageIO 2.4 leaves its PNG reader by a long jump, over a string with the message: 31 bytes a broken file.
extern "C" const char* __lsan_default_suppressions() {  // NOLINT(bugprone-reserved-identifier)
  return "leak:ImageInput::geterror";
}

namespace umbral {
namespace {

using test::bytes_of, test::message_of, test::put_bytes;
using testing::HasSubstr;

template <class T>
void write_image(const std::string& path, int width, int height, int channels, OIIO::TypeDesc type,
                 const std::vector<T>& pixels) {
  const auto output = OIIO::ImageOutput::create(path);
  ASSERT_TRUE(output) << OIIO::geterror();
  OIIO::ImageSpec spec(width, height, channels, type);
  spec.attribute("oiio:UnassociatedAlpha", 1);
  ASSERT_TRUE(output->open(path, spec) && output->write_image(OIIO::BaseTypeFromC<T>::value, pixels.data()) &&
              output->close())
      << output->geterror();
}

class TextureLoader : public testing::Test {
 protected:
  std::string path(const std::string& name) const { return (directory_.path() / name).string(); }
  TextureImage load(const std::string& name, ColorSpace space = ColorSpace::automatic) {
    return load_texture_image(path(name), space, repairs_);
  }
  std::string refusal(const std::string& name) {
    return message_of<SceneError>([&] { load(name); });
  }

  test::TemporaryDirectory directory_;
  std::vector<std::string> repairs_;
};

// 2 × 2, rows from the top: red, green / blue, (10, 20, 30)
const std::vector<std::uint8_t> four{255, 0, 0, 0, 255, 0, 0, 0, 255, 10, 20, 30};

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

TEST_F(TextureLoader, WhatIsNoImageIsALocatedError) {
  EXPECT_EQ(refusal("none.png"), path("none.png") + ": error: there is no such file");
  EXPECT_EQ(refusal("."), path(".") + ": error: it is not a regular file");
  put_bytes(path("empty.png"), "");
  EXPECT_EQ(refusal("empty.png"), path("empty.png") + ": error: the file is empty");
  put_bytes(path("text.png"), "this is no picture, whatever its name says");
  EXPECT_THAT(refusal("text.png"), HasSubstr(path("text.png") + ": error: the image cannot be read: "));
  put_bytes(path("text.unknown"), "neither is this");
  EXPECT_THAT(refusal("text.unknown"), HasSubstr("error: the image cannot be read: "));
}

// Noise does not compress, so that a file is texels almost to its end (the last 2.2 % of the TGA are a
// footer).
TEST_F(TextureLoader, TruncatedFilesAreErrors) {
  std::mt19937 random(8);
  std::vector<std::uint8_t> bytes(3 * 96 * 80);
  for (std::uint8_t& byte : bytes) byte = static_cast<std::uint8_t>(random());
  std::vector<float> floats(bytes.begin(), bytes.end());
  for (const char* name : {"a.png", "a.jpg", "a.tga", "a.bmp", "a.tif", "a.exr", "a.hdr"}) {
    const bool hdr = name == std::string("a.exr") || name == std::string("a.hdr");
    if (hdr)
      write_image(path(name), 96, 80, 3, OIIO::TypeDesc::FLOAT, floats);
    else
      write_image(path(name), 96, 80, 3, OIIO::TypeDesc::UINT8, bytes);
    EXPECT_EQ(refusal(name), "") << name;
    const std::string whole = bytes_of(path(name));
    for (const double part : {0.0005, 0.002, 0.01, 0.1, 0.5, 0.9, 0.97}) {
      put_bytes(path(name),
                whole.substr(0, static_cast<std::size_t>(part * static_cast<double>(whole.size()))));
      EXPECT_THAT(refusal(name), HasSubstr(path(name) + ": error: ")) << name << ' ' << part;
    }
  }
}

TEST_F(TextureLoader, DamagedFilesNeverCrash) {
  std::mt19937 random(9);
  std::vector<std::uint8_t> bytes(3 * 24 * 20);
  for (std::uint8_t& byte : bytes) byte = static_cast<std::uint8_t>(random());
  for (const char* name : {"a.png", "a.jpg", "a.tga", "a.exr"}) {
    write_image(path(name), 24, 20, 3, OIIO::TypeDesc::UINT8, bytes);
    const std::string whole = bytes_of(path(name));
    int errors = 0;
    for (int trial = 0; trial < 100; ++trial) {
      std::string damaged = whole;
      for (int i = 0; i < 3; ++i)
        damaged[random() % (trial < 50 ? 100 : damaged.size())] = static_cast<char>(random());
      put_bytes(path(name), damaged);
      errors += !refusal(name).empty();
    }
    EXPECT_GT(errors, 0) << name;
  }
}

TEST_F(TextureLoader, AbsurdlyLargeImagesAreRefusedBeforeTheyAreRead) {
  const auto put_hdr = [&](std::size_t bytes) {
    put_bytes(path("a.hdr"),
              "#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y 60138 +X 60138\n" + std::string(bytes, '\1'));
  };
  put_hdr(500000);
  EXPECT_THAT(refusal("a.hdr"),
              HasSubstr("the image has 60138 x 60138 texels, more than the 536870912 supported"));
  put_hdr(100);
  EXPECT_THAT(refusal("a.hdr"), HasSubstr("bytes cannot hold 60138 x 60138 texels"));
  // OpenImageIO would take two minutes for this one, and 10 GB for the next.
  write_image(path("a.jpg"), 8, 8, 3, OIIO::TypeDesc::UINT8, std::vector<float>(192, 0.5f));
  std::string jpeg = bytes_of(path("a.jpg"));
  const std::size_t frame = jpeg.find("\xff\xc0");
  ASSERT_NE(frame, std::string::npos);
  for (std::size_t i = frame + 5; i < frame + 9; ++i) jpeg[i] = static_cast<char>(0xea);  // 60138 × 60138
  put_bytes(path("a.jpg"), jpeg);
  EXPECT_THAT(refusal("a.jpg"), HasSubstr("bytes cannot hold 60138 x 60138 texels"));
  write_image(path("a.tga"), 2, 2, 3, OIIO::TypeDesc::UINT8, four);
  std::string bytes = bytes_of(path("a.tga"));
  bytes[12] = bytes[13] = bytes[14] = bytes[15] = static_cast<char>(0xea);  // 60138 × 60138, little endian
  put_bytes(path("a.tga"), bytes);
  EXPECT_THAT(refusal("a.tga"), HasSubstr("bytes cannot hold 60138 x 60138 texels"));
}

// Every format that scenes come with, by the same picture: what codes and floats can hold of it.
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

TEST_F(TextureLoader, RefusesBrokenPfm) {
  const auto refused = [&](const std::string& bytes) {
    put_bytes(path("a.pfm"), bytes);
    return refusal("a.pfm");
  };
  EXPECT_THAT(refused("P6\n1 1\n255\nabc"), HasSubstr("does not begin with PF"));
  EXPECT_THAT(refused("PF\n1"), HasSubstr("'' is not a number"));
  EXPECT_THAT(refused("PF\n1 x\n-1\n"), HasSubstr("'x' is not a number"));
  EXPECT_THAT(refused("PF\n0 1\n-1\n"), HasSubstr("is 0"));
  EXPECT_THAT(refused("PF\n2 2\n-1\nabcd"), HasSubstr("ends before its 2 x 2 texels"));
  EXPECT_THAT(refused("PF\n2000000 2000000\n-1\n"), HasSubstr("more than the"));
  EXPECT_THAT(refused(""), HasSubstr("empty"));
  EXPECT_THAT(refusal("none.pfm"), HasSubstr("no such file"));
}

// What does not fit stays in its file, and look-ups cannot tell.
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
