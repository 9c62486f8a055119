// Samples of glTF whose labels say what must look like what.
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>

#include "real_scenes/region_ratios.h"
#include "support/paths.h"

namespace umbral::test {
namespace {

constexpr int shrink = 4;

struct Seen {
  Vec3d mean, standard_error;
};

// Of a square around a point, in pixels of the scene's own 512 × 512.
Seen seen(const SmallImage& image, const glm::ivec2& middle, int half) {
  Seen sum{Vec3d(0), Vec3d(0)};
  int count = 0;
  for (int y = (middle.y - half) / shrink; y <= (middle.y + half) / shrink; ++y)
    for (int x = (middle.x - half) / shrink; x <= (middle.x + half) / shrink; ++x, ++count) {
      const auto i = static_cast<std::size_t>(y * image.width + x);
      sum.mean += image.mean[i];
      sum.standard_error += image.standard_error[i] * image.standard_error[i];
    }
  return {sum.mean / static_cast<double>(count), glm::sqrt(sum.standard_error) / static_cast<double>(count)};
}

class GltfLabels : public testing::Test {
 protected:
  // The sample as it lights and frames itself.
  SmallImage sample(const std::string& name, int shrink_by = shrink) {
    const auto folder = shared_scene(name);
    if (!folder) return {};
    for (const auto& entry : std::filesystem::recursive_directory_iterator(*folder))
      if (entry.path().extension() == ".gltf" || entry.path().extension() == ".glb")
        return rendered(entry.path(), shrink_by, 32);
    return {};
  }

  // Alike to `share` of the brightest channel, and noise.
  static void expect_alike(const Seen& tested, const Seen& model, double share, const std::string& what) {
    const double allowed = share * std::max({model.mean.r, model.mean.g, model.mean.b}) + 1e-4;
    for (int c = 0; c < 3; ++c)
      EXPECT_NEAR(tested.mean[c], model.mean[c],
                  allowed + 4 * (tested.standard_error[c] + model.standard_error[c]))
          << what << ", channel " << c;
  }
};

// The column "Test" is as the column "Sample pass". The first row, "single-sided", is darker there, in the shadow of what
// only rays from behind pass.
TEST_F(GltfLabels, TexturesAreClampedRepeatedAndMirroredInSAndInT) {
  const SmallImage image = sample("gltf-alpha-and-textures/TextureSettingsTest");
  if (image.mean.empty()) GTEST_SKIP() << no_shared_scenes;
  for (const int y : {163, 209, 255, 301, 347, 394, 440})
    expect_alike(seen(image, {276, y}, 16), seen(image, {372, y}, 16), 0.04,
                 "the row at " + std::to_string(y));
}

TEST_F(GltfLabels, VertexColoursAreThoseOfTheSamples) {
  const SmallImage image = sample("gltf-alpha-and-textures/VertexColorTest");
  if (image.mean.empty()) GTEST_SKIP() << no_shared_scenes;
  for (const int x : {129, 256, 392})
    expect_alike(seen(image, {x, 178}, 40), seen(image, {x, 378}, 40), 0.04, "at " + std::to_string(x));
}

// Textures, encoded in whatever way, are as the factor in the first column.
TEST_F(GltfLabels, TexturesAreDecodedToTheFactors) {
  const SmallImage image = sample("gltf-alpha-and-textures/TextureEncodingTest");
  if (image.mean.empty()) GTEST_SKIP() << no_shared_scenes;
  for (const int y : {198, 285, 369})
    for (const int x : {263, 349, 436})
      expect_alike(seen(image, {x, y}, 16), seen(image, {177, y}, 16), 0.05,
                   "at " + std::to_string(x) + ", " + std::to_string(y));
}

TEST_F(GltfLabels, SpecularFactorsAndTexturesAreTheSame) {
  const SmallImage image = sample("gltf-material-extensions/SpecularTest");
  if (image.mean.empty()) GTEST_SKIP() << no_shared_scenes;
  for (const auto& [factor, texture] : {std::pair{123, 167}, {211, 256}, {300, 344}})
    for (const int x : {285, 329, 373, 418, 462})
      expect_alike(seen(image, {x, texture}, 14), seen(image, {x, factor}, 14), 0.06,
                   "at " + std::to_string(x) + ", " + std::to_string(texture));
}

// How what the coat adds to the base, square for square, goes with what the coat is on black: their correlation.
double coat_likeness(const SmallImage& image, int row, int row_of_coating) {
  constexpr int half = 24, base = 257, coated = 329, coating = 399;
  double n = 0, x = 0, y = 0, xx = 0, yy = 0, xy = 0;
  const auto at = [&](int column, int middle, int i, int j) {
    return image.mean[static_cast<std::size_t>((middle + j) / 2 * image.width + (column + i) / 2)].g;
  };
  for (int j = -half; j <= half; j += 2)
    for (int i = -half; i <= half; i += 2) {
      const double added = at(coated, row, i, j) - at(base, row, i, j);
      const double alone = at(coating, row_of_coating, i, j);
      n += 1, x += added, y += alone, xx += added * added, yy += alone * alone, xy += added * alone;
    }
  return (n * xy - x * y) / std::sqrt((n * xx - x * x) * (n * yy - y * y));
}

// Smooth over the ridges of the base, and ridged where the coat alone has the map. Standard errors are about 0.04, the
// differences 0.36 and 0.32.
TEST_F(GltfLabels, ClearcoatsHaveTheNormalsOfTheColumnCoatingOnly) {
  const SmallImage image = sample("gltf-material-extensions/ClearCoatTest", 2);
  if (image.mean.empty()) GTEST_SKIP() << no_shared_scenes;
  constexpr int of_base = 302, of_coat = 443;  // the rows of the two normal maps
  EXPECT_GT(coat_likeness(image, of_base, of_base), coat_likeness(image, of_base, of_coat) + 0.15);
  EXPECT_GT(coat_likeness(image, of_coat, of_coat), coat_likeness(image, of_coat, of_base) + 0.15);
}

}  // namespace
}  // namespace umbral::test
