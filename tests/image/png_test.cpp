// Tone mapping and PNG files.
#include "image/png.h"

#include <cmath>
#include <limits>
#include <vector>

#include <OpenImageIO/imageio.h>
#include <gtest/gtest.h>

#include "core/error.h"
#include "files.h"
#include "support/paths.h"

namespace umbral {
namespace {

constexpr float nan = std::numeric_limits<float>::quiet_NaN();

std::vector<std::uint8_t> pixels_of(const std::string& path, int width, int height) {
  const auto input = OIIO::ImageInput::open(path);
  EXPECT_TRUE(input) << OIIO::geterror();
  EXPECT_EQ(input->spec().width, width);
  EXPECT_EQ(input->spec().height, height);
  EXPECT_EQ(input->spec().nchannels, 3);
  EXPECT_EQ(input->spec().format, OIIO::TypeDesc::UINT8);
  std::vector<std::uint8_t> pixels(3 * static_cast<std::size_t>(width) * height);
  EXPECT_TRUE(input->read_image(0, 0, 0, 3, OIIO::TypeDesc::UINT8, pixels.data()));
  return pixels;
}

// Every code of sRGB, decoded and written, comes back as itself, and rows stay in their order.
TEST(Png, EveryCodeComesBack) {
  const test::TemporaryDirectory directory;
  const std::string path = (directory.path() / "a.png").string();
  std::vector<Spectrum> linear;
  for (int i = 0; i < 256; ++i) {
    const float v = srgb_decode(static_cast<float>(i) / 255);
    linear.push_back(rgb(v, srgb_decode(static_cast<float>(255 - i) / 255), 0));
  }
  write_png(path, 64, 4, linear);
  const std::vector<std::uint8_t> pixels = pixels_of(path, 64, 4);
  for (int i = 0; i < 256; ++i) {
    EXPECT_EQ(pixels[3 * i], i);
    EXPECT_EQ(pixels[3 * i + 1], 255 - i);
    EXPECT_EQ(pixels[3 * i + 2], 0);
  }
}

TEST(Png, CodesAreRoundedToTheNearest) {
  const test::TemporaryDirectory directory;
  const std::string path = (directory.path() / "a.png").string();
  const std::vector<Spectrum> linear{grey(srgb_decode(100.49f / 255)), grey(srgb_decode(100.51f / 255))};
  write_png(path, 2, 1, linear);
  EXPECT_EQ(pixels_of(path, 2, 1), (std::vector<std::uint8_t>{100, 100, 100, 101, 101, 101}));
}

TEST(DisplayColour, HueKeepsRatios) {
  const Spectrum shown = display_colour(rgb(8, 4, 2), 0, ToneMap::hue);
  EXPECT_FLOAT_EQ(shown.r, 1);
  EXPECT_FLOAT_EQ(shown.g, srgb_encode(0.5f));
  EXPECT_FLOAT_EQ(shown.b, srgb_encode(0.25f));
  const Spectrum below = display_colour(rgb(0.5f, 0.2f, 0), 0, ToneMap::hue);
  EXPECT_FLOAT_EQ(below.r, srgb_encode(0.5f));
  EXPECT_FLOAT_EQ(below.g, srgb_encode(0.2f));
}

TEST(DisplayColour, ClipAndReinhard) {
  const Spectrum clipped = display_colour(rgb(8, 0.5f, 0), 0, ToneMap::clip);
  EXPECT_FLOAT_EQ(clipped.r, 1);
  EXPECT_FLOAT_EQ(clipped.g, srgb_encode(0.5f));
  EXPECT_FLOAT_EQ(display_colour(rgb(1, 0.5f, 0), 0, ToneMap::reinhard).g, srgb_encode(0.25f));
}

TEST(DisplayColour, ExposureIsInStops) {
  EXPECT_FLOAT_EQ(display_colour(grey(0.1f), 2, ToneMap::hue).r, srgb_encode(0.4f));
  EXPECT_FLOAT_EQ(display_colour(grey(0.4f), -2, ToneMap::hue).r, srgb_encode(0.1f));
}

TEST(DisplayColour, WhatIsNotANumberIsSeen) {
  for (const ToneMap map : {ToneMap::hue, ToneMap::clip, ToneMap::reinhard}) {
    EXPECT_EQ(display_colour(rgb(0, nan, 0), 0, map), rgb(1, 0, 1));
    EXPECT_EQ(display_colour(rgb(infinity, 0, 0), 0, map), white);
    EXPECT_EQ(display_colour(rgb(3e38f, 0, 0), 10, map), white);
    EXPECT_EQ(display_colour(rgb(-1, -infinity, 0), 0, map), black);
  }
}

TEST(Png, FailuresLeaveNothing) {
  const test::TemporaryDirectory directory;
  const std::string path = (directory.path() / "a.png").string();
  const std::vector<Spectrum> linear(64 * 64, grey(0.5f));
  {
    const test::FileSizeLimit limit(50);
    EXPECT_EQ(test::message_of<OutputError>([&] { write_png(path, 64, 64, linear); }),
              "cannot write '" + path + "': File too large");
  }
  EXPECT_EQ(test::files_in(directory.path()), 0u);
  EXPECT_THROW(write_png("/nowhere/a.png", 64, 64, linear), OutputError);
}

}  // namespace
}  // namespace umbral
