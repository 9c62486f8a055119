// Cutting an image into tiles.
#include "analysis/regions.h"

#include <fmt/format.h>

namespace umbral {

Region whole_image(int width, int height) { return {"image", 0, 0, width, height, true}; }

std::vector<Region> tiles(int width, int height, int columns, int rows) {
  std::vector<Region> regions;
  for (int j = 0; j < rows; ++j)
    for (int i = 0; i < columns; ++i)
      regions.push_back({fmt::format("tile ({}, {})", i, j), width * i / columns, height * j / rows,
                         width * (i + 1) / columns, height * (j + 1) / rows});
  return regions;
}

std::vector<Region> image_and_tiles(int width, int height, int columns, int rows) {
  std::vector<Region> regions{whole_image(width, height)};
  if (columns * rows == 1) return regions;
  const std::vector<Region> parts = tiles(width, height, columns, rows);
  regions.insert(regions.end(), parts.begin(), parts.end());
  return regions;
}

MeanEstimate Replicates::estimate(std::size_t region, int channel) const {
  std::vector<double> values;
  values.reserve(means.size());
  for (const std::vector<Vec3d>& replicate : means) values.push_back(replicate[region][channel]);
  return mean_of(values);
}

}  // namespace umbral
