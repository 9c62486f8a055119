// Mitsuba's own test scenes against the means and variances of the images that come with them.
#include <gtest/gtest.h>

#include <algorithm>

#include <fmt/format.h>
#include <boost/math/distributions/normal.hpp>

#include "real_scenes/region_ratios.h"
#include "support/paths.h"

namespace umbral::test {
namespace {

struct MitsubaScene {
  const char* name;
  const char* file;       // below tests/scenes
  const char* reference;  // without its ending
  int shrink = 1;         // means of so many pixels across are compared, with as many samples in all
};

void PrintTo(const MitsubaScene& scene, std::ostream* out) { *out << scene.name; }

class MitsubaReference : public testing::TestWithParam<MitsubaScene> {};

INSTANTIATE_TEST_SUITE_P(
    Scenes, MitsubaReference,
    testing::Values(MitsubaScene{"textured_diffuse", "bsdf_spheres/test_textured_diffuse_path.xml",
                                 "bsdf_spheres/refs/test_textured_diffuse_ref_rgb"},
                    MitsubaScene{"instancing", "instancing/test_instancing_path.xml",
                                 "instancing/refs/test_instancing_ref_rgb"},
                    MitsubaScene{"mirrors", "infinite_mirrors/scene_path.xml",
                                 "infinite_mirrors/refs/scene_ref_rgb"},
                    MitsubaScene{"face_colours", "mesh_attributes/test_mesh_attributes_3_face_direct.xml",
                                 "mesh_attributes/refs/test_mesh_attributes_3_face_ref_rgb"},
                    MitsubaScene{"face_weights", "mesh_attributes/test_mesh_attributes_1_face_direct.xml",
                                 "mesh_attributes/refs/test_mesh_attributes_1_face_ref_rgb"},
                    MitsubaScene{"thrown_image", "spot_light/test_spot_direct.xml",
                                 "spot_light/refs/test_spot_ref_rgb", 4},
                    MitsubaScene{"constant", "bsdf_spheres/test_constant_path.xml",
                                 "bsdf_spheres/refs/test_constant_ref_rgb"},
                    MitsubaScene{"vertex_colours", "mesh_attributes/test_mesh_attributes_3_vertex_direct.xml",
                                 "mesh_attributes/refs/test_mesh_attributes_3_vertex_ref_rgb"}),
    [](const auto& tested) { return std::string(tested.param.name); });

// Mitsuba's own z test takes z = |difference| √(samples/variance), its variance images being those of single samples. They
// are no use alone: what is left of cancelled digits is negative in many pixels. So a pixel's variance is the larger of that
// and umbral's own, and 1 % of its value is allowed beside (references of an environment lie half a texel aside). Of all
// pixels and channels at most one in a thousand may have a p-value below 1e-5. A whole that is off by 0.6 % and a ninth of it
// that is off by 3 % are found in nine cases of ten. The thrown image is compared in blocks: its spot is asked once in 18 times,
// too rarely for the error bars of single pixels.
TEST_P(MitsubaReference, AgreesByPixelsRegionsAndTheWhole) {
  const auto root = shared_scene("mitsuba3-tests/tests/scenes");
  if (!root) GTEST_SKIP() << no_shared_scenes;
  const int shrink = GetParam().shrink, spp = 128 * shrink * shrink;
  const SmallImage ours = rendered(*root / GetParam().file, shrink, spp);
  const std::string reference = *root / GetParam().reference;
  const SmallImage mean = shrunk(reference + ".exr", shrink),
                   variance = shrunk(reference + "_var.exr", shrink);
  ASSERT_EQ(ours.mean.size(), mean.mean.size());
  int beyond = 0;
  const boost::math::normal normal;
  const double limit = quantile(complement(normal, 0.5e-5));
  for (std::size_t i = 0; i < mean.mean.size(); ++i)
    for (int c = 0; c < 3; ++c) {
      const double noise = std::max(variance.mean[i][c] / spp, sqr(ours.standard_error[i][c]));
      const double allowed = 0.01 * mean.mean[i][c] + limit * std::sqrt(noise);
      if (std::abs(ours.mean[i][c] - mean.mean[i][c]) > allowed + 1e-4) ++beyond;
    }
  const RegionRatio whole = whole_ratio(ours, mean);
  fmt::print("  {}: {:.4f} ± {:.4f}, {} of {} beyond\n", GetParam().name, whole.ratio, whole.standard_error,
             beyond, 3 * mean.mean.size());
  EXPECT_LE(beyond, static_cast<int>(3 * mean.mean.size() / 1000));
  EXPECT_NEAR(whole.ratio, 1, 0.004 + 4 * whole.standard_error);
  for (const RegionRatio& region : region_ratios(ours, mean, 3))
    if (std::isfinite(region.ratio)) {
      EXPECT_NEAR(region.ratio, 1, 0.01 + 4 * region.standard_error);
    }
}

}  // namespace
}  // namespace umbral::test
