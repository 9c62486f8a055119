// Regions: the parts of an image whose means are tested, and those means in independent replicates of it.
#pragma once

#include <string>
#include <vector>

#include "analysis/estimate.h"
#include "core/math.h"

namespace umbral {

// Pixels x0 ≤ x < x1, y0 ≤ y < y1, at least one; y down from the top.
struct Region {
  std::string name;
  int x0, y0, x1, y1;
  bool whole = false;  // the whole image

  std::size_t pixels() const { return static_cast<std::size_t>(x1 - x0) * static_cast<std::size_t>(y1 - y0); }
};

// The whole image, named "image".
Region whole_image(int width, int height);

// Its tiles, row by row from the top, named "tile (column, row)". Not more columns or rows than pixels.
std::vector<Region> tiles(int width, int height, int columns, int rows);

// The whole image and, if there are more than one, its tiles.
std::vector<Region> image_and_tiles(int width, int height, int columns, int rows);

// The mean of each region; `pixel(x, y)` is a Vec3d.
template <class Pixel>
std::vector<Vec3d> region_means(const std::vector<Region>& regions, const Pixel& pixel) {
  std::vector<Vec3d> means;
  for (const Region& region : regions) {
    Vec3d sum(0);
    for (int y = region.y0; y < region.y1; ++y)
      for (int x = region.x0; x < region.x1; ++x) sum += pixel(x, y);
    means.push_back(sum / static_cast<double>(region.pixels()));
  }
  return means;
}

// What the statistics of an image rest on: whole-image replicates, which are independent whatever a sampler does to
// neighbouring pixels.
struct Replicates {
  std::vector<Region> regions;
  std::vector<std::vector<Vec3d>> means;  // one a replicate, each one a region

  MeanEstimate estimate(std::size_t region, int channel) const;
};

}  // namespace umbral
