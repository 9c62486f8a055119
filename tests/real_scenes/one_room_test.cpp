// The same Cornell box from files of three formats.
#include <gtest/gtest.h>

#include <fstream>

#include <fmt/format.h>

#include "real_scenes/region_ratios.h"
#include "support/paths.h"

namespace umbral::test {
namespace {

// Written by hand from the pbrt file.
constexpr const char* own_format = R"(
[camera]
position = [0, 1, 6.8]
look_at = [0, 1, 0]
fov = 19.5
[film]
width = 1024
height = 1024
[integrator.path]
max_depth = 65
[materials]
left = { type = "matte", reflectance = [0.63, 0.065, 0.05] }
right = { type = "matte", reflectance = [0.14, 0.45, 0.091] }
grey = { type = "matte", reflectance = [0.725, 0.71, 0.68] }
[[shapes]]
type = "rectangle"
origin = [-1, 0, 1]
edge_u = [2, 0, 0]
edge_v = [0, 0, -2]
material = "grey"
[[shapes]]
type = "rectangle"
origin = [-1, 2, -1]
edge_u = [2, 0, 0]
edge_v = [0, 0, 2]
material = "grey"
[[shapes]]
type = "rectangle"
origin = [-1, 0, -1]
edge_u = [2, 0, 0]
edge_v = [0, 2, 0]
material = "grey"
[[shapes]]
type = "rectangle"
origin = [-1, 0, 1]
edge_u = [0, 0, -2]
edge_v = [0, 2, 0]
material = "left"
[[shapes]]
type = "rectangle"
origin = [1, 0, -1]
edge_u = [0, 0, 2]
edge_v = [0, 2, 0]
material = "right"
[[shapes]]
type = "box"
low = [-1, -1, -1]
high = [1, 1, 1]
material = "grey"
transform = [{ matrix = [[0.0851643, 0.289542, 0, 0.328631], [0, 0, -0.3, 0.3], [-0.284951, 0.0865363, 0, 0.374592], [0, 0, 0, 1]] }]
[[shapes]]
type = "box"
low = [-1, -1, -1]
high = [1, 1, 1]
material = "grey"
transform = [{ matrix = [[0.286776, 0.098229, 0, -0.335439], [0, 0, -0.6, 0.6], [-0.0997984, 0.282266, 0, -0.291415], [0, 0, 0, 1]] }]
[[shapes]]
type = "rectangle"
origin = [-0.24, 1.98, -0.22]
edge_u = [0.47, 0, 0]
edge_v = [0, 0, 0.38]
emission = [17, 12, 4]
)";

// Sixteen regions of 16 × 16 pixels: their ratios are known to 0.3 %, and none may be off by more than 4.5 of those and
// 0.1 % (a false alarm in a thousand runs). The reference has 16-bit numbers and its own noise: 1 % beside.
TEST(CornellBox, IsTheSameFromThreeFormats) {
  const auto folder = shared_scene("cornell-box");
  if (!folder) GTEST_SKIP() << no_shared_scenes;
  const TemporaryDirectory temporary;
  const std::filesystem::path own = temporary.path() / "cornell-box.toml";
  std::ofstream(own) << own_format;
  const std::vector<std::string> files{*folder / "scene-v4.pbrt", *folder / "scene-mitsuba3.xml", own};
  const SmallImage reference = shrunk(*folder / "reference.exr", 16);
  std::vector<SmallImage> images;
  for (const std::string& file : files) {
    images.push_back(rendered(file, 16, 128, images.size()));
    const RegionRatio whole = whole_ratio(images.back(), reference);
    fmt::print("  {}: {:.4f} ± {:.4f} of the reference\n", file, whole.ratio, whole.standard_error);
    EXPECT_NEAR(whole.ratio, 1, 0.003 + 4 * whole.standard_error) << file;
    for (const RegionRatio& region : region_ratios(images.back(), reference, 4))
      EXPECT_NEAR(region.ratio, 1, 0.01 + 4 * region.standard_error) << file;
    for (const RegionRatio& region : region_ratios(images.back(), images.front(), 4)) {
      EXPECT_LT(region.standard_error, 0.012);
      EXPECT_NEAR(region.ratio, 1, 0.001 + 4.5 * std::sqrt(2.0) * region.standard_error) << file;
    }
  }
}

}  // namespace
}  // namespace umbral::test
