// The statistical gate: whole-image replicates against an oracle or against each other, with power in the verdict.
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "analysis/equality.h"
#include "core/math.h"

namespace umbral::test {

// Mean radiance of each pixel, row by row from the top.
struct PixelImage {
  int width = 0, height = 0;
  std::vector<Vec3d> pixels;

  const Vec3d& at(int x, int y) const { return pixels[static_cast<std::size_t>(y) * width + x]; }
};

// The chance that a run of everything gated, all of it right, raises any alarm at first, and again when what
// raised it is repeated. It is shared evenly among as many experiments as there may be (Bonferroni), because each
// runs as a test of its own, and within an experiment among its statistics by Holm [1979].
inline constexpr double suite_alpha = 1e-3, repeated_suite_alpha = 1e-4;
inline constexpr int most_experiments = 80;

// Replicates of an image. With 32, Student's t needs 0.6 times the samples that it needs with 16.
inline constexpr int gate_replicates = 32;

struct GateSettings : EqualitySettings {
  GateSettings() { alpha = suite_alpha / most_experiments; }  // of this experiment
  int tiles = 4;  // a side of the image; 1 judges the mean of the image alone
};

// The means of the image and of its tiles, as the tests of equality want them.
Replicates replicates_of(const std::vector<PixelImage>& images, int tiles);

// One-sample t tests against the truth; at least two replicates.
Judgement judged(const std::vector<PixelImage>& replicates, const PixelImage& truth,
                 const GateSettings& settings);
// The t tests of [Welch 1947] of two sets of replicates.
Judgement judged(const std::vector<PixelImage>& a, const std::vector<PixelImage>& b,
                 const GateSettings& settings);

// Renders one replicate; `effort` multiplies its samples.
using RenderReplicate = std::function<PixelImage(std::uint64_t seed, int effort)>;

// The gate's procedure without a word: gate_replicates from `first_seed` on, and the one repetition.
Judgement settled_against(const PixelImage& truth, const RenderReplicate& render,
                          const GateSettings& settings, std::uint64_t first_seed);

// gate_replicates with fixed seeds; where they do not agree, be it for want of power, as many fresh ones of four
// times the samples decide at repeated_suite_alpha. What was measured is printed and recorded with the test.
testing::AssertionResult agrees_with(const PixelImage& truth, const RenderReplicate& render,
                                     GateSettings settings = {});
testing::AssertionResult same_mean(const RenderReplicate& a, const RenderReplicate& b,
                                   GateSettings settings = {});

}  // namespace umbral::test
