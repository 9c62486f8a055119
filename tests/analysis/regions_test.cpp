// Tiles cover an image once; their means are those of their pixels.
#include "analysis/regions.h"

#include <gtest/gtest.h>

namespace umbral {
namespace {

TEST(Regions, TilesCoverEveryPixelOnce) {
  std::vector<int> covered(13 * 7);
  for (const Region& tile : tiles(13, 7, 4, 3)) {
    EXPECT_GE(tile.pixels(), 6u) << tile.name;
    for (int y = tile.y0; y < tile.y1; ++y)
      for (int x = tile.x0; x < tile.x1; ++x) ++covered[y * 13 + x];
  }
  EXPECT_EQ(covered, std::vector<int>(13 * 7, 1));
}

TEST(Regions, OneTileIsTheImageAndNotTestedTwice) {
  EXPECT_EQ(image_and_tiles(4, 4, 1, 1).size(), 1u);
  EXPECT_EQ(image_and_tiles(4, 4, 2, 2).size(), 5u);
}

TEST(Regions, MeansAreThoseOfTheirPixels) {
  const auto pixel = [](int x, int y) { return Vec3d(x, y, 1); };
  const std::vector<Vec3d> means = region_means(image_and_tiles(4, 2, 2, 1), pixel);
  ASSERT_EQ(means.size(), 3u);
  EXPECT_EQ(means[0], Vec3d(1.5, 0.5, 1));
  EXPECT_EQ(means[2], Vec3d(2.5, 0.5, 1));
}

}  // namespace
}  // namespace umbral
