// Replicates are renders of their own seeds, and their spread is what a film with error bars expects of it.
#include "render/replicates.h"

#include <set>

#include <gtest/gtest.h>

#include "core/statistics.h"
#include "integrators/path.h"
#include "render/test_scenes.h"

namespace umbral::test {
namespace {

RenderOptions small(int spp, int replicates) {
  RenderOptions options;
  options.film = {12, 10, FilterKind::box, 0};
  options.sampling = {spp, replicates, SamplerKind::sobol, 3};
  return options;
}

TEST(Replicates, SeedsOfRunsSetsAndReplicatesAllDiffer) {
  std::set<std::uint64_t> seeds;
  for (std::uint64_t run = 0; run < 20; ++run)
    for (std::uint64_t set = 0; set < 20; ++set)
      for (std::uint64_t replicate = 0; replicate < 20; ++replicate)
        seeds.insert(replicate_seed(run, set, replicate));
  EXPECT_EQ(seeds.size(), 8000u);
  EXPECT_EQ(seeds.count(0), 0u);
}

TEST(Replicates, AReplicateIsTheRenderOfItsSeed) {
  const Scene scene(open_air());
  PathIntegrator path;
  RenderOptions options = small(8, 2);
  options.crop = Crop{2, 1, 9, 8};
  const auto replicate = render_replicate(scene, path, options, 77);
  ASSERT_TRUE(replicate);
  options.sampling.seed = 77;
  const RenderResult result = render(scene, path, options);
  ASSERT_EQ(replicate->pixels.size(), 49u);
  for (int y = 1; y < 8; ++y)
    for (int x = 2; x < 9; ++x)
      EXPECT_EQ(replicate->pixels[static_cast<std::size_t>((y - 1) * 7 + x - 2)], result.film->at(x, y).mean);
  EXPECT_EQ(replicate->seed, 77u);
  EXPECT_EQ(replicate->rejected, 0u);
  EXPECT_GT(replicate->wall_seconds, 0);
  EXPECT_GE(replicate->cpu_seconds, 0);
}

// 64 replicates of one scramble against the error bars of 64 scrambles within one film. Both estimate the same mean
// variance of a pixel; 120 pixels with 63 degrees of freedom each leave some 2 % of spread to each were the pixels
// alike, and heavy tails make it several times that.
TEST(Replicates, TheirSpreadIsTheVarianceThatAFilmFinds) {
  const Scene scene(open_air());
  PathIntegrator path;
  constexpr int count = 64;
  std::vector<std::array<Moments, 3>> moments(120);
  for (std::uint64_t r = 0; r < count; ++r) {
    const auto replicate = render_replicate(scene, path, small(4, 1), replicate_seed(5, 0, r));
    for (std::size_t i = 0; i < moments.size(); ++i)
      for (int c = 0; c < 3; ++c) moments[i][static_cast<std::size_t>(c)].add(replicate->pixels[i][c]);
  }
  double variance = 0;
  for (const auto& pixel : moments)
    for (const Moments& channel : pixel) variance += channel.variance() / (3.0 * 120);
  const RenderResult film = render(scene, path, small(4 * count, count));
  EXPECT_NEAR(variance / (count * film.film->image_error().pixel_variance()), 1, 0.25);
}

TEST(Replicates, OneThatWasCancelledIsNone) {
  const Scene scene(open_air());
  PathIntegrator path;
  const std::atomic<bool> cancelled{true};
  EXPECT_FALSE(render_replicate(scene, path, small(4, 1), 1, {{}, &cancelled}));
}

}  // namespace
}  // namespace umbral::test
