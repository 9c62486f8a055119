// Counts, sums, stop rules and first-hit features of whole renders.
#include "render/renderer.h"

#include <gtest/gtest.h>

#include "integrators/path.h"
#include "render/test_scenes.h"
#include "support/scene_kit.h"

namespace umbral::test {
namespace {

RenderOptions small(int spp, int replicates) {
  RenderOptions options;
  options.film = {12, 10, FilterKind::tent, 0};
  options.sampling = {spp, replicates, SamplerKind::sobol, 3};
  options.tile = 4;
  return options;
}

TEST(Renderer, EveryPixelGetsTheSamplesAsked) {
  const Scene scene(open_air());
  PathIntegrator path;
  const struct {
    int spp, replicates, reached;
  } cases[] = {{64, 8, 64}, {100, 8, 104}, {3, 8, 3}, {1, 1, 1}, {300, 1, 300}, {7, 2, 8}};
  for (const auto& c : cases) {
    const RenderResult result = render(scene, path, small(c.spp, c.replicates));
    EXPECT_EQ(result.film->layout().replicates, std::min(c.replicates, c.spp));
    for (int y = 0; y < 10; ++y)
      for (int x = 0; x < 12; ++x) EXPECT_EQ(result.film->at(x, y).samples, c.reached);
    EXPECT_EQ(result.film->image_error().samples, 120 * c.reached);
    EXPECT_EQ(result.stop_reason, "samples");
  }
}

// Mean and standard error of a pixel from its samples drawn one by one, in double.
PixelEstimate one_by_one(const PixelSampler& pixels, int x, int y, int replicates, std::uint64_t samples) {
  std::vector<Vec3d> means;
  Vec3d mean(0), squares(0);
  for (int r = 0; r < replicates; ++r) {
    Vec3d sum(0);
    for (std::uint64_t i = 0; i < samples; ++i)
      sum += Vec3d(Vec3(pixels
                            .sample({0, static_cast<std::uint32_t>(x), static_cast<std::uint32_t>(y),
                                     static_cast<std::uint32_t>(r), i},
                                    {})
                            .radiance));
    means.push_back(sum / static_cast<double>(samples));
    mean += means.back() / static_cast<double>(replicates);
  }
  for (const Vec3d& m : means) squares += sqr(m - mean);
  return {mean, sqrt(squares / (replicates * (replicates - 1.0))), 0};
}

// The film holds the samples 0 … n−1 of each replicate, each once, however many passes they came in. Sums within a
// pass are single precision: at most 128 additions, each off by half a unit in the last place at most.
TEST(Renderer, PassesAddUpToTheSamplesOneByOne) {
  const Scene scene(open_air());
  PathIntegrator path;
  for (const int per_replicate : {1, 7, 64, 300}) {
    const RenderOptions options = small(4 * per_replicate, 4);
    const RenderResult result = render(scene, path, options);
    const PixelSampler pixels(scene, path, options.film, options.sampling);
    for (const auto& [x, y] : {std::pair{0, 0}, std::pair{5, 6}, std::pair{11, 9}}) {
      const PixelEstimate film = result.film->at(x, y);
      const PixelEstimate truth = one_by_one(pixels, x, y, 4, static_cast<std::uint64_t>(per_replicate));
      for (int c = 0; c < 3; ++c) {
        EXPECT_NEAR(film.mean[c], truth.mean[c], 128 * 0x1p-24 * truth.mean[c]);
        EXPECT_NEAR(film.standard_error[c], truth.standard_error[c], 128 * 0x1p-24 * truth.mean[c]);
      }
    }
  }
}

// A render that time cuts short holds the same samples as one that was asked for as many.
TEST(Renderer, ARenderCutByTimeIsAShorterRender) {
  const Scene scene(open_air());
  PathIntegrator path;
  RenderOptions timed = small(1, 4);
  timed.sampling.spp = 1 << 24;
  timed.seconds = 0.3;
  const RenderResult cut = render(scene, path, timed);
  EXPECT_EQ(cut.stop_reason, "time 0.3 s");
  const int reached = static_cast<int>(cut.film->at(0, 0).samples);
  ASSERT_GT(reached, 4);
  const RenderResult asked = render(scene, path, small(reached, 4));
  for (int y = 0; y < 10; ++y)
    for (int x = 0; x < 12; ++x) {
      const PixelEstimate a = cut.film->at(x, y), b = asked.film->at(x, y);
      EXPECT_EQ(a.samples, b.samples);
      for (int c = 0; c < 3; ++c) EXPECT_NEAR(a.mean[c], b.mean[c], 128 * 0x1p-24 * b.mean[c]);
    }
}

TEST(Renderer, StopsAtTheErrorAskedAndNoLater) {
  const Scene scene(open_air());
  PathIntegrator path;
  RenderOptions options = small(1, 8);
  options.spp_bounds = false;
  options.relative_error = 0.02;
  const RenderResult result = render(scene, path, options);
  EXPECT_TRUE(result.stop_reason.starts_with("target error 2 % reached: at most ")) << result.stop_reason;
  EXPECT_TRUE(result.target.reached);
  EXPECT_LE(result.target.limit, 0.02);
  EXPECT_LT(result.film->image_error().relative(), result.target.limit);
  const int reached = static_cast<int>(result.film->at(0, 0).samples);
  const RenderResult earlier = render(scene, path, small(reached * 3 / 4, 8));
  EXPECT_GT(earlier.film->image_error().relative_limit(0.95), 0.02);
}

TEST(Renderer, FirstHitFeatures) {
  SceneDescription description;
  description.camera = camera({1, 2, 5}, {1, 2, 0}, 60, {0, 1, 0});
  add_shape(description, rectangle({-9, -9, 1}, {10, 0, 0}, {0, 18, 0}),
            add_matte(description, rgb(0.1f, 0.2f, 0.3f)));
  const Scene scene(std::move(description));
  PathIntegrator path;
  RenderOptions options = small(16, 4);
  options.film.filter = FilterKind::box;
  options.auxiliary = true;
  const auto film = render(scene, path, options).film;
  const AuxiliaryPixel left = film->auxiliary(0, 3), right = film->auxiliary(11, 3);
  for (int c = 0; c < 3; ++c) EXPECT_NEAR(left.albedo[c], rgb(0.1f, 0.2f, 0.3f)[c], 1e-6);
  EXPECT_EQ(left.normal, Vec3(0, 0, 1));
  EXPECT_NEAR(left.depth, 4, 1e-5);  // along the axis, not along the ray
  EXPECT_EQ(right.albedo, Vec3(0));  // the plane ends in the middle of the image
  EXPECT_TRUE(std::isinf(right.depth));
}

}  // namespace
}  // namespace umbral::test
