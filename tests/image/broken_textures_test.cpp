// Image files that are broken.
#include <random>

#include "texture_kit.h"

// OpenImageIO 2.4 leaves its PNG reader by a long jump, over a string with the message: 31 bytes a broken file.
// NOLINTNEXTLINE(bugprone-reserved-identifier,readability-identifier-naming)
extern "C" const char* __lsan_default_suppressions() { return "leak:ImageInput::geterror"; }

namespace umbral {
namespace {

using test::bytes_of;
using test::four;
using test::put_bytes;
using test::TextureLoader;
using test::write_image;
using testing::HasSubstr;

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
  put_bytes(path("a.ppm"), "P6\n20000 20000\n255\nabc");
  EXPECT_THAT(refusal("a.ppm"), HasSubstr("bytes cannot hold 20000 x 20000 texels"));
}

// Every format that scenes come with, by the same picture: what codes and floats can hold of it.
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

}  // namespace
}  // namespace umbral
