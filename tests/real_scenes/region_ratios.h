// Renders of others' scene files against the images that others made of them.
#pragma once

#include <string>
#include <vector>

#include "formats/read_options.h"
#include "image/exr.h"
#include "render/renderer.h"

namespace umbral::test {

struct SmallImage {
  int width = 0, height = 0;
  std::vector<Vec3d> mean, standard_error;  // row by row; no errors of images that tell none
};

// The scene at 1/shrink of its own size through a box filter, by 16 replicates of the scene's own integrator.
SmallImage rendered(const std::string& scene, int shrink, int spp, std::uint64_t seed = 0);

// The means of shrink × shrink pixels.
SmallImage shrunk(const std::string& exr, int shrink);

// Of one cell of a grid × grid division, over all three channels.
struct RegionRatio {
  double ratio = 0, standard_error = 0;  // of the first image over the second
};
std::vector<RegionRatio> region_ratios(const SmallImage& ours, const SmallImage& theirs, int grid);

// Of the whole image.
RegionRatio whole_ratio(const SmallImage& ours, const SmallImage& theirs);

}  // namespace umbral::test
