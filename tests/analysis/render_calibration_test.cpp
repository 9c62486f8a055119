// That pixels of our renders are independent, so that errors of pixels add up to errors of images: comparisons of
// renders that differ in their seeds alone.
#include <gtest/gtest.h>

#include "analysis/equality.h"
#include "integrators/path.h"
#include "render/renderer.h"
#include "support/scene_kit.h"

namespace umbral::test {
namespace {

constexpr int size = 16;

// A ball on a floor under a lamp and an even sky.
SceneDescription ball() {
  SceneDescription scene;
  scene.camera = camera({0, -4, 2}, {0, 0, 0.4f}, 35);
  const MaterialId floor = add_matte(scene, grey(0.5f)), red = add_matte(scene, rgb(0.7f, 0.2f, 0.1f));
  add_shape(scene, rectangle({-3, -3, 0}, {6, 0, 0}, {0, 6, 0}), floor);
  add_shape(scene, sphere({0, 0, 0.5f}, 0.5f), red);
  add_shape(scene, rectangle({-1, -1, 3}, {0, 2, 0}, {2, 0, 0}), floor, grey(3));
  scene.environment.emplace();
  scene.environment->radiance = grey(0.2f);
  scene.environment->prepare();
  return scene;
}

// As its file would be read again.
EstimatedImage estimated(const Film& film) {
  EstimatedImage image{Planes(size, size), ErrorSource::pixels, Planes(size, size), 7, 8};
  for (int y = 0; y < size; ++y)
    for (int x = 0; x < size; ++x) {
      const PixelEstimate pixel = film.at(x, y);
      const auto i = static_cast<std::size_t>(y * size + x);
      for (int c = 0; c < 3; ++c) {
        image.mean.channels[c][i] = static_cast<float>(pixel.mean[c]);
        image.variance.channels[c][i] = static_cast<float>(sqr(pixel.standard_error[c]));
      }
    }
  return image;
}

class RenderCalibration : public testing::TestWithParam<SamplerKind> {};

// Errors of the image that were wrong by a fifth would give 10 % of alarms at 5 %, and those of pixels that share their
// random numbers many times that.
TEST_P(RenderCalibration, ErrorsOfPixelsAreThoseOfTheImage) {
  constexpr int runs = 200;
  const Scene scene(ball());
  PathIntegrator path;
  path.max_depth = 3;
  EqualitySettings settings;
  settings.alpha = 0.05;
  int alarms = 0, below_half = 0, below_5 = 0;
  for (int run = 0; run < runs; ++run) {
    const auto image = [&](int side) {
      RenderOptions options;
      options.film = {size, size, FilterKind::box, 0};
      options.sampling = {16, 8, GetParam(), static_cast<std::uint64_t>(2 * run + side)};
      return estimated(*render(scene, path, options).film);
    };
    const Judgement judgement = judged(image(0), image(1), image_and_tiles(size, size, 2, 2), settings);
    alarms += judgement.outcome == Outcome::differs;
    below_half += judgement.statistics[1].p < 0.5;
    below_5 += judgement.statistics[1].p < 0.05;
  }
  // All but one case in a thousand.
  EXPECT_LE(alarms, 0.05 * runs + 3.1 * std::sqrt(0.05 * 0.95 * runs));
  EXPECT_NEAR(below_half, 0.5 * runs, 3.3 * std::sqrt(0.25 * runs));
  EXPECT_NEAR(below_5, 0.05 * runs, 3.3 * std::sqrt(0.05 * 0.95 * runs));
  RecordProperty("alarms_of_200_at_5_percent", alarms);
  RecordProperty("image_p_below_5_percent", below_5);
  RecordProperty("image_p_below_half", below_half);
}

INSTANTIATE_TEST_SUITE_P(Samplers, RenderCalibration,
                         testing::Values(SamplerKind::sobol, SamplerKind::independent),
                         [](const auto& tested) {
                           return sampler_names()[static_cast<std::size_t>(tested.param)];
                         });

}  // namespace
}  // namespace umbral::test
