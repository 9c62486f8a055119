// OpenEXR files: exact round trips, foreign layouts, broken files and failing disks.
#include "image/exr.h"

#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <random>

#include <OpenEXR/ImfArray.h>
#include <OpenEXR/ImfChannelList.h>
#include <OpenEXR/ImfChromaticitiesAttribute.h>
#include <OpenEXR/ImfDeepFrameBuffer.h>
#include <OpenEXR/ImfDeepScanLineOutputFile.h>
#include <OpenEXR/ImfFrameBuffer.h>
#include <OpenEXR/ImfHeader.h>
#include <OpenEXR/ImfInputFile.h>
#include <OpenEXR/ImfOutputFile.h>
#include <OpenEXR/ImfPartType.h>
#include <OpenEXR/ImfStandardAttributes.h>
#include <OpenEXR/ImfTiledOutputFile.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/error.h"
#include "files.h"
#include "support/paths.h"

namespace umbral {
namespace {

namespace fs = std::filesystem;
using test::bytes_of, test::files_in, test::message_of, test::put_bytes;
using testing::HasSubstr;

// Any bits a float can have, so that compression cannot hide a loss.
ExrImage random_image() {
  ExrImage image{37, 29, 5, 3, 31, 28, {}, {}};
  std::mt19937 random(7);
  for (const char* name : {"B", "G", "R", "samples.Y", "stderr.R"}) {
    ExrChannel channel{name, std::vector<float>(26 * 25)};
    for (float& pixel : channel.pixels) pixel = std::bit_cast<float>(static_cast<std::uint32_t>(random()));
    image.channels.push_back(std::move(channel));
  }
  const float infinite = std::numeric_limits<float>::infinity();
  image.channels[0].pixels = std::vector<float>(26 * 25, -0.0f);
  image.channels[0].pixels[1] = infinite;
  image.channels[0].pixels[2] = std::numeric_limits<float>::denorm_min();
  image.attributes = {{"umbral:seeds", std::string("18446744073709551615")},
                      {"umbral:empty", std::string()},
                      {"umbral:text", std::string("two\nlines, ünïcode")},
                      {"samplesPerPixel", 64},
                      {"renderTimeSeconds", 1.25f},
                      {"umbral:mean", 0.1},
                      {"umbral:error", std::numeric_limits<double>::infinity()}};
  return image;
}

void expect_same(const ExrImage& a, const ExrImage& b) {
  EXPECT_EQ(std::tie(a.width, a.height, a.x0, a.y0, a.x1, a.y1),
            std::tie(b.width, b.height, b.x0, b.y0, b.x1, b.y1));
  ASSERT_EQ(a.channels.size(), b.channels.size());
  for (const ExrChannel& channel : a.channels) {
    const ExrChannel* const other = b.find(channel.name);
    ASSERT_NE(other, nullptr) << channel.name;
    ASSERT_EQ(channel.pixels.size(), other->pixels.size());
    for (std::size_t i = 0; i < channel.pixels.size(); ++i)
      ASSERT_EQ(std::bit_cast<std::uint32_t>(channel.pixels[i]),
                std::bit_cast<std::uint32_t>(other->pixels[i]));
  }
}

TEST(Exr, RoundTripIsBitExact) {
  const test::TemporaryDirectory directory;
  const std::string path = (directory.path() / "a.exr").string();
  const ExrImage image = random_image();
  write_exr(path, image);
  const ExrImage back = read_exr(path);
  expect_same(image, back);
  for (const auto& [name, value] : image.attributes) {
    ASSERT_TRUE(back.attributes.contains(name)) << name;
    EXPECT_EQ(back.attributes.at(name), value) << name;
  }
  EXPECT_EQ(*back.attribute<int>("samplesPerPixel"), 64);
  EXPECT_EQ(back.attribute<double>("samplesPerPixel"), nullptr);
  EXPECT_EQ(back.find("alpha"), nullptr);
}

TEST(Exr, WritingTheSameImageTwiceGivesTheSameBytes) {
  const test::TemporaryDirectory directory;
  const fs::path a = directory.path() / "a.exr", b = directory.path() / "b.exr";
  write_exr(a.string(), random_image());
  write_exr(b.string(), random_image());
  EXPECT_EQ(bytes_of(a), bytes_of(b));
}

TEST(Exr, OtherReadersFindTheStandardThings) {
  const test::TemporaryDirectory directory;
  const std::string path = (directory.path() / "a.exr").string();
  write_exr(path, random_image());
  const Imf::InputFile file(path.c_str());
  EXPECT_TRUE(file.isComplete());
  EXPECT_EQ(file.header().compression(), Imf::ZIP_COMPRESSION);
  EXPECT_EQ(file.header().displayWindow(), Imath::Box2i({0, 0}, {36, 28}));
  EXPECT_EQ(file.header().dataWindow(), Imath::Box2i({5, 3}, {30, 27}));
  ASSERT_TRUE(Imf::hasChromaticities(file.header()));
  const Imf::Chromaticities& rec709 = Imf::chromaticities(file.header());
  EXPECT_EQ(rec709.red, Imath::V2f(0.64f, 0.33f));
  EXPECT_EQ(rec709.white, Imath::V2f(0.3127f, 0.3290f));
  for (auto channel = file.header().channels().begin(); channel != file.header().channels().end(); ++channel)
    EXPECT_EQ(channel.channel().type, Imf::FLOAT) << channel.name();
}

TEST(Exr, HalfAndIntegerChannelsBecomeFloat) {
  const test::TemporaryDirectory directory;
  const std::string path = (directory.path() / "a.exr").string();
  Imf::Header header(2, 1);
  header.channels().insert("Y", Imf::Channel(Imf::HALF));
  header.channels().insert("id", Imf::Channel(Imf::UINT));
  half y[2] = {half(0.5f), half(-3.0f)};
  unsigned id[2] = {7, 1'000'000};
  {
    Imf::FrameBuffer buffer;
    buffer.insert("Y", Imf::Slice(Imf::HALF, reinterpret_cast<char*>(y), sizeof(half), 0));
    buffer.insert("id", Imf::Slice(Imf::UINT, reinterpret_cast<char*>(id), sizeof(unsigned), 0));
    Imf::OutputFile file(path.c_str(), header);
    file.setFrameBuffer(buffer);
    file.writePixels(1);
  }
  const ExrImage image = read_exr(path);
  EXPECT_EQ(image.find("Y")->pixels, (std::vector<float>{0.5f, -3.0f}));
  EXPECT_EQ(image.find("id")->pixels, (std::vector<float>{7, 1'000'000}));
}

TEST(Exr, ReadsTiledFilesAndDisplayWindowsThatStartElsewhere) {
  const test::TemporaryDirectory directory;
  const std::string path = (directory.path() / "a.exr").string();
  std::vector<float> pixels(40 * 20);
  for (std::size_t i = 0; i < pixels.size(); ++i) pixels[i] = static_cast<float>(i);
  {
    Imf::Header header(Imath::Box2i({10, 20}, {59, 59}), Imath::Box2i({15, 25}, {54, 44}));
    header.channels().insert("R", Imf::Channel(Imf::FLOAT));
    header.setTileDescription(Imf::TileDescription(16, 16, Imf::ONE_LEVEL));
    Imf::TiledOutputFile file(path.c_str(), header);
    Imf::FrameBuffer buffer;
    buffer.insert("R", Imf::Slice::Make(Imf::FLOAT, pixels.data(), header.dataWindow()));
    file.setFrameBuffer(buffer);
    file.writeTiles(0, file.numXTiles() - 1, 0, file.numYTiles() - 1);
  }
  const ExrImage image = read_exr(path);
  EXPECT_EQ(image.width, 50);
  EXPECT_EQ(image.height, 40);
  EXPECT_EQ(std::tie(image.x0, image.y0, image.x1, image.y1), std::make_tuple(5, 5, 45, 25));
  EXPECT_EQ(image.find("R")->pixels, pixels);
}

std::string reading_error(const fs::path& path) {
  return message_of<SceneError>([&] { read_exr(path.string()); });
}

TEST(Exr, BrokenFilesAreLocatedErrors) {
  const test::TemporaryDirectory directory;
  const fs::path path = directory.path() / "a.exr";
  EXPECT_EQ(reading_error(path), path.string() + ": error: there is no such file");
  EXPECT_EQ(reading_error(directory.path()), directory.path().string() + ": error: it is not a regular file");
  put_bytes(path, "");
  EXPECT_THAT(reading_error(path), HasSubstr("it is not an OpenEXR image"));
  put_bytes(path, "P6 1 1 255 abc and more");
  EXPECT_THAT(reading_error(path), HasSubstr("it is not an OpenEXR image"));
}

TEST(Exr, AFileTruncatedAnywhereIsAnError) {
  const test::TemporaryDirectory directory;
  const fs::path path = directory.path() / "a.exr";
  write_exr(path.string(), random_image());
  const std::string bytes = bytes_of(path);
  for (std::size_t size = 0; size < bytes.size(); size += 1 + size / 16) {
    put_bytes(path, bytes.substr(0, size));
    EXPECT_THAT(reading_error(path), HasSubstr(path.string() + ": error: "))
        << size << " of " << bytes.size();
  }
  put_bytes(path, bytes.substr(0, bytes.size() - 1));
  EXPECT_NE(reading_error(path), "");
}

// As renderers leave it that write in place: the table says which scan lines are there.
TEST(Exr, AFileWhoseWriterWasInterruptedIsTruncated) {
  const test::TemporaryDirectory directory;
  const std::string path = (directory.path() / "a.exr").string();
  std::vector<float> pixels(64 * 64);
  {
    Imf::Header header(64, 64);
    header.channels().insert("R", Imf::Channel(Imf::FLOAT));
    Imf::OutputFile file(path.c_str(), header);
    Imf::FrameBuffer buffer;
    buffer.insert("R", Imf::Slice::Make(Imf::FLOAT, pixels.data(), header.dataWindow()));
    file.setFrameBuffer(buffer);
    file.writePixels(40);
  }
  EXPECT_EQ(reading_error(path), path + ": error: it is truncated");
}

// Neither a crash nor an endless loop; a flipped bit of a float is a value like any other, so some do read.
TEST(Exr, FlippedBytesNeverCrash) {
  const test::TemporaryDirectory directory;
  const fs::path path = directory.path() / "a.exr";
  write_exr(path.string(), random_image());
  const std::string bytes = bytes_of(path);
  std::mt19937 random(11);
  int errors = 0;
  for (int trial = 0; trial < 300; ++trial) {
    std::string damaged = bytes;
    const std::size_t place = trial < 150 ? random() % 700 : random() % bytes.size();
    damaged[place] = static_cast<char>(random());
    put_bytes(path, damaged);
    errors += !reading_error(path).empty();
  }
  EXPECT_GT(errors, 50);
}

TEST(Exr, RefusesSubsampledAndDeepAndHugeImages) {
  const test::TemporaryDirectory directory;
  const std::string path = (directory.path() / "a.exr").string();
  {
    Imf::Header header(4, 4);
    header.channels().insert("BY", Imf::Channel(Imf::HALF, 2, 2));
    Imf::OutputFile file(path.c_str(), header);
    half pixels[4] = {};
    Imf::FrameBuffer buffer;
    buffer.insert("BY", Imf::Slice(Imf::HALF, reinterpret_cast<char*>(pixels), 2, 4, 2, 2));
    file.setFrameBuffer(buffer);
    file.writePixels(4);
  }
  EXPECT_THAT(reading_error(path), HasSubstr("its channel 'BY' is subsampled"));
  {
    Imf::Header header(1, 1);
    header.setType(Imf::DEEPSCANLINE);
    header.compression() = Imf::NO_COMPRESSION;
    header.channels().insert("Z", Imf::Channel(Imf::FLOAT));
    const Imf::DeepScanLineOutputFile file(path.c_str(), header);
  }
  EXPECT_THAT(reading_error(path), HasSubstr("deep data"));
  {
    Imf::Header header(100'000, 100'000);
    header.channels().insert("Y", Imf::Channel(Imf::HALF));
    const Imf::OutputFile file(path.c_str(), header);
  }
  EXPECT_NE(reading_error(path), "");
}

TEST(Exr, AFullDiskLeavesNothing) {
  const test::TemporaryDirectory directory;
  const fs::path path = directory.path() / "a.exr";
  const ExrImage image = random_image();
  write_exr(path.string(), image);
  const auto size = fs::file_size(path);
  fs::remove(path);
  for (const auto limited : {std::uintmax_t{0}, std::uintmax_t{100}, size / 2, size - 1}) {
    std::string message;
    {
      const test::FileSizeLimit limit(limited);
      message = message_of<OutputError>([&] { write_exr(path.string(), image); });
    }
    EXPECT_EQ(message, "cannot write '" + path.string() + "': File too large") << limited;
    EXPECT_EQ(files_in(directory.path()), 0u) << limited;
  }
}

TEST(Exr, AFailedWriteKeepsTheOldFile) {
  const test::TemporaryDirectory directory;
  const fs::path path = directory.path() / "a.exr";
  const ExrImage image = random_image();
  write_exr(path.string(), image);
  const std::string before = bytes_of(path);
  {
    const test::FileSizeLimit limit(2000);
    EXPECT_THROW(write_exr(path.string(), image), OutputError);
  }
  EXPECT_EQ(bytes_of(path), before);
  EXPECT_EQ(files_in(directory.path()), 1u);
}

TEST(Exr, AnUnwritablePathIsAnOutputError) {
  EXPECT_THAT(message_of<OutputError>([] { write_exr("/nowhere/a.exr", random_image()); }),
              HasSubstr("cannot write '/nowhere/a.exr': there is no directory '/nowhere'"));
}

TEST(Exr, AnAttributeThatOpenExrRefusesIsAnOutputError) {
  const test::TemporaryDirectory directory;
  ExrImage image = random_image();
  image.attributes["compression"] = std::string("none");
  EXPECT_THROW(write_exr((directory.path() / "a.exr").string(), image), OutputError);
  EXPECT_EQ(files_in(directory.path()), 0u);
}

}  // namespace
}  // namespace umbral
