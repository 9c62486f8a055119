// What happens in the course of a render: refused samples, cancellation, exceptions, progress.
#include <atomic>
#include <stdexcept>
#include <thread>

#include <gtest/gtest.h>

#include "core/parallel.h"
#include "render/renderer.h"
#include "support/scene_kit.h"
#include "support/stability.h"

namespace umbral::test {
namespace {

// A sample knows itself by the numbers it would draw: those after the one of its pixel's filter.
Vec2 mark_of(const SamplingSettings& settings, SampleId id) {
  id.seed = settings.seed;
  Sampler sampler(settings.sampler, id);
  sampler.next2d();
  return sampler.next2d();
}

// Radiance 1 but for what `react` says about the sample with that mark.
class Scripted : public Integrator {
 public:
  std::function<Spectrum(const Vec2& mark)> react;

  void describe(ParameterVisitor&) override {}
  std::vector<std::string> layers() const override { return {"all"}; }
  Spectrum radiance(const Scene&, const Ray&, Sampler& sampler, std::span<Spectrum> layers) const override {
    const Spectrum value = react(sampler.next2d());
    if (!layers.empty()) layers[0] += value;
    return value;
  }
};

class RenderEvents : public testing::Test {
 protected:
  RenderEvents() {
    options_.film = {16, 12, FilterKind::box, 0};
    options_.sampling = {64, 4, SamplerKind::sobol, 9};
    options_.layers = true;
    options_.tile = 4;
  }

  Scene scene_{SceneDescription{}};
  Scripted integrator_;
  RenderOptions options_;
};

TEST_F(RenderEvents, RefusedSamplesAreCountedLocatedAndReplayable) {
  struct Bad {
    SampleId id;
    Spectrum value;
  };
  const float nan = std::numeric_limits<float>::quiet_NaN();
  const Bad bad[] = {{{0, 3, 2, 1, 5}, grey(nan)},
                     {{0, 15, 11, 3, 15}, rgb(1, infinity, 1)},
                     {{0, 0, 0, 0, 0}, rgb(1, 1, -0.5f)}};
  integrator_.react = [&](const Vec2& mark) {
    for (const Bad& b : bad)
      if (mark == mark_of(options_.sampling, b.id)) return b.value;
    return white;
  };
  const RenderResult result = render(scene_, integrator_, options_);
  EXPECT_EQ(result.film->rejected(), 3u);
  const std::vector<RejectedSample> found = result.film->first_rejected();
  ASSERT_EQ(found.size(), 3u);
  const PixelSampler pixels(scene_, integrator_, options_.film, options_.sampling);
  for (std::size_t i = 0; i < 3; ++i) {
    const Bad& expected = bad[(i + 2) % 3];  // told in the order of the image
    EXPECT_EQ(found[i].x, static_cast<int>(expected.id.x));
    EXPECT_EQ(found[i].y, static_cast<int>(expected.id.y));
    EXPECT_EQ(found[i].replicate, static_cast<int>(expected.id.replicate));
    EXPECT_EQ(found[i].index, expected.id.index);
    const SampleId again{0, static_cast<std::uint32_t>(found[i].x), static_cast<std::uint32_t>(found[i].y),
                         static_cast<std::uint32_t>(found[i].replicate), found[i].index};
    EXPECT_FALSE(is_valid_radiance(pixels.sample(again, {}).radiance));
  }
  // A refused sample counts as black, in the image and in its layers.
  EXPECT_EQ(result.film->at(3, 2).mean, Vec3d(63.0 / 64));
  EXPECT_EQ(result.film->layer(0, 3, 2), Vec3d(63.0 / 64));
  EXPECT_EQ(result.film->at(3, 2).samples, 64);
  EXPECT_EQ(result.film->at(4, 2).mean, Vec3d(1));
  record({"Nothing hidden", "a sample that is NaN, infinite or negative is not counted, or not found again",
          "3 of 3 counted, located and replayed", fmt::format("{} of 3", found.size()),
          "pbrt-v4 #211: NaN after 18 h"});
}

// Each thread ends the tile it is in, at most.
TEST_F(RenderEvents, StopsAtTheFirstRefusedSampleIfAsked) {
  integrator_.react = [](const Vec2&) { return grey(-1); };
  options_.tile = 2;
  options_.stop_at_rejected = true;
  const RenderResult result = render(scene_, integrator_, options_);
  EXPECT_EQ(result.stop_reason, "a rejected sample");
  EXPECT_GE(result.film->rejected(), 1u);
  EXPECT_LE(result.film->rejected(), 4u * 64 * static_cast<unsigned>(available_threads()));
  integrator_.react = [](const Vec2&) { return white; };
  EXPECT_NE(render(scene_, integrator_, options_).stop_reason, "a rejected sample");
}

TEST_F(RenderEvents, OnlyTheFirstRefusedSamplesAreKeptAndTheyAreTheSameEveryTime) {
  integrator_.react = [](const Vec2& mark) { return mark.x < 0.25f ? grey(-1) : white; };
  const RenderResult a = render(scene_, integrator_, options_), b = render(scene_, integrator_, options_);
  EXPECT_NEAR(static_cast<double>(a.film->rejected()), 16 * 12 * 16, 200);
  const std::vector<RejectedSample> of_a = a.film->first_rejected(), of_b = b.film->first_rejected();
  ASSERT_EQ(of_a.size(), 16u);
  for (std::size_t i = 0; i < 16; ++i) {
    EXPECT_EQ(of_a[i].index, of_b[i].index);
    EXPECT_EQ(of_a[i].x, of_b[i].x);
    EXPECT_EQ(of_a[i].y, 0);
  }
}

TEST_F(RenderEvents, CancellationLeavesAFilmThatIsRight) {
  std::atomic<bool> cancelled = false;
  std::atomic<int> samples = 0;
  integrator_.react = [&](const Vec2&) {
    if (++samples == 5000) cancelled = true;
    return white;
  };
  options_.sampling.spp = 1 << 20;
  const RenderResult result = render(scene_, integrator_, options_, {{}, &cancelled});
  EXPECT_EQ(result.stop_reason, "interrupted");
  EXPECT_LT(samples, 5000 + 16 * 128 * 4 * 8);  // each thread ends its tile
  double counted = 0;
  for (int y = 0; y < 12; ++y)
    for (int x = 0; x < 16; ++x) {
      const PixelEstimate pixel = result.film->at(x, y);
      counted += pixel.samples;
      EXPECT_EQ(pixel.mean, Vec3d(pixel.samples > 0 ? 1 : 0));
    }
  EXPECT_EQ(counted, samples);
  EXPECT_EQ(result.film->image_error().samples, counted);
}

TEST_F(RenderEvents, CancelledBeforeTheStartIsAnEmptyFilm) {
  const std::atomic<bool> cancelled = true;
  integrator_.react = [](const Vec2&) { return white; };
  const RenderResult result = render(scene_, integrator_, options_, {{}, &cancelled});
  EXPECT_EQ(result.film->image_error().pixels, 0u);
  EXPECT_EQ(result.film->at(1, 1).samples, 0);
}

TEST_F(RenderEvents, ExceptionsReachTheCaller) {
  integrator_.react = [&](const Vec2& mark) -> Spectrum {
    if (mark == mark_of(options_.sampling, {0, 7, 7, 2, 3})) throw std::runtime_error("from a worker");
    return white;
  };
  try {
    render(scene_, integrator_, options_);
    FAIL() << "nothing was thrown";
  } catch (const std::runtime_error& error) {
    EXPECT_STREQ(error.what(), "from a worker");
  }
}

TEST_F(RenderEvents, ProgressGrowsToOneAndIsToldByOneThreadAtATime) {
  integrator_.react = [](const Vec2&) { return white; };
  std::atomic<int> inside = 0;
  double share = 0;
  int reports = 0;
  RenderHooks hooks;
  hooks.progress = [&](const RenderProgress& progress) {
    EXPECT_EQ(++inside, 1);
    EXPECT_GE(progress.share, share);
    share = progress.share;
    ++reports;
    --inside;
  };
  options_.sampling.spp = 4096;
  render(scene_, integrator_, options_, hooks);
  EXPECT_EQ(share, 1);
  EXPECT_GE(reports, 2);
}

}  // namespace
}  // namespace umbral::test
