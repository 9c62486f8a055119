// pbrt scenes against the images that Tungsten made of the files they come from (docs/formats.md tells what differs).
#include <gtest/gtest.h>

#include <fmt/format.h>

#include "real_scenes/region_ratios.h"
#include "support/paths.h"

namespace umbral::test {
namespace {

void compare(const char* folder_name, int shrink, int spp, double whole_tolerance, double region_tolerance,
             double share_of_regions) {
  const auto folder = shared_scene(folder_name);
  if (!folder) GTEST_SKIP() << no_shared_scenes;
  const SmallImage ours = rendered(*folder / "scene-v4.pbrt", shrink, spp),
                   theirs = shrunk(*folder / "reference.exr", shrink);
  const RegionRatio whole = whole_ratio(ours, theirs);
  const std::vector<RegionRatio> regions = region_ratios(ours, theirs, 4);
  const auto good = std::count_if(regions.begin(), regions.end(), [&](const RegionRatio& region) {
    return std::abs(region.ratio - 1) <= region_tolerance + 3 * region.standard_error;
  });
  for (const RegionRatio& region : regions)
    fmt::print(" {:.3f}({:.3f})", region.ratio, region.standard_error);
  fmt::print("\n  {}: {:.4f} ± {:.4f} of the reference, {} of {} regions within {:g}\n", folder_name,
             whole.ratio, whole.standard_error, good, regions.size(), region_tolerance);
  EXPECT_NEAR(whole.ratio, 1, whole_tolerance + 3 * whole.standard_error);
  EXPECT_GE(static_cast<double>(good), share_of_regions * static_cast<double>(regions.size()));
}

TEST(TungstenReference, ModernHall) { compare("modern-hall", 8, 128, 0.01, 0.01, 1); }

// The pot is brighter here: docs/formats.md.
TEST(TungstenReference, CoffeeMaker) { compare("coffee-maker", 10, 256, 0.01, 0.02, 0.75); }

}  // namespace
}  // namespace umbral::test
