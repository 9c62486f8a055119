// Images that are decoded before they are asked for.
#include "image/images_ahead.h"

#include <chrono>
#include <condition_variable>
#include <mutex>
#include <stdexcept>

#include <gtest/gtest.h>

#include "core/parallel.h"

namespace umbral {
namespace {

DecodedImage grey_image(float value) {
  TexelGrid<Float4> grid(1, 1);
  grid.set(0, 0, Spectrum(value, value, value, 1));
  return {TextureImage(std::move(grid))};
}

ImagesAhead::Key key(const std::string& name) { return {name, ColorSpace::linear}; }

TEST(ImagesAhead, GivesEachImageOnceAndDecodesItOnce) {
  ImagesAhead ahead({});
  int decoded = 0;
  for (int i = 0; i < 2; ++i)
    ahead.expect(key("a"), [&] {
      ++decoded;
      return grey_image(0.25f);
    });
  const auto image = ahead.take(key("a"));
  ASSERT_TRUE(image);
  EXPECT_EQ(image->image.texel(0, 0).r, 0.25f);
  EXPECT_FALSE(ahead.take(key("a")));
  EXPECT_FALSE(ahead.take({"a", ColorSpace::srgb})) << "another image, which nobody expected";
  ahead.decode_expected();
  EXPECT_EQ(decoded, 1);
}

TEST(ImagesAhead, WhatCannotBeDecodedIsNotThereAndHarmsNoOther) {
  ImagesAhead ahead({});
  ahead.expect(key("broken"), []() -> DecodedImage { throw std::runtime_error("broken"); });
  ahead.expect(key("whole"), [] { return grey_image(0.5f); });
  EXPECT_FALSE(ahead.take(key("broken")));
  EXPECT_TRUE(ahead.take(key("whole")));
}

TEST(ImagesAhead, CountsUpToAllThatWereExpected) {
  std::vector<std::pair<std::size_t, std::size_t>> told;
  ImagesAhead ahead([&](std::size_t done, std::size_t count) { told.emplace_back(done, count); });
  for (const char* name : {"a", "b", "c"}) ahead.expect(key(name), [] { return grey_image(1); });
  ahead.decode_expected();
  ahead.expect(key("d"), [] { return grey_image(1); });
  EXPECT_TRUE(ahead.take(key("d")));
  const std::vector<std::pair<std::size_t, std::size_t>> expected{{1, 3}, {2, 3}, {3, 3}, {4, 4}};
  EXPECT_EQ(told, expected);
}

// Each waits until the other has begun, which one thread after the other never does.
TEST(ImagesAhead, DecodesSideBySide) {
  if (available_threads() < 2) GTEST_SKIP() << "there is one processor";
  std::mutex mutex;
  std::condition_variable changed;
  int begun = 0;
  bool together = true;
  const auto decode = [&] {
    std::unique_lock lock(mutex);
    ++begun;
    changed.notify_all();
    together &= changed.wait_for(lock, std::chrono::seconds(20), [&] { return begun == 2; });
    return grey_image(1);
  };
  ImagesAhead ahead({});
  ahead.expect(key("a"), decode);
  ahead.expect(key("b"), decode);
  ahead.decode_expected();
  EXPECT_TRUE(together);
}

}  // namespace
}  // namespace umbral
