// Do two images have the same mean? Tests of many statistics together, with their power in the verdict.
#pragma once

#include <string>
#include <vector>

#include "analysis/estimated_image.h"

namespace umbral {

struct EqualitySettings {
  double alpha = 1e-3;  // the chance that equal images differ in any statistic
  // What rounding may be off by, relative: not a difference.
  double resolution = 1e-5;
  double image_mde = 0.005, tile_mde = 0.03;  // smallest relative differences that must not go unseen
  // What they are relative to: the mean of the region in the channel, or this share of the mean of the whole image in
  // all channels if that is more. With 0 a black tile is never seen well enough.
  double scale_floor = 0;
};

enum class StatisticKind {
  image,        // the mean of the image in one channel
  tile,         // that of a tile
  squared_bias  // the mean squared difference over all pixels and channels, 0 or more
};

// One number tested.
struct Statistic {
  std::string name;
  StatisticKind kind = StatisticKind::image;
  double expected = 0, measured = 0;
  BehrensFisher error = {};  // of measured − expected
  double skewness = 0;       // of the replicates
  double scale = 0;          // what mde is relative to, above 0 or nothing is seen
  double p = 1;              // two-sided, but of a squared bias: that can only be too large
  // The relative difference that is found in about nine cases of ten; of a squared bias the root of it.
  double mde = 0;
};

enum class Outcome {
  agrees,
  differs,
  underpowered,  // a difference that matters could go unseen
  skewed,        // these replicates are not as normal as the tests ask
};

const char* name_of(Outcome outcome);

struct Judgement {
  Outcome outcome = Outcome::agrees;
  std::vector<Statistic> statistics;
  std::vector<std::size_t> rejected;  // by Holm's procedure, most significant first

  double worst_mde(StatisticKind kind) const;  // 0 if there is none of the kind
  double smallest_p() const;
  double mean_skewness() const;
  std::string text() const;  // of several lines if something is wrong
};

// The statistic of `measured` against `expected`, yet without p and mde, at the scale of `expected`.
Statistic statistic(std::string name, StatisticKind kind, const MeanEstimate& expected,
                    const MeanEstimate& measured);

// Fills p and mde in and judges all of them together.
Judgement judged(std::vector<Statistic> statistics, const EqualitySettings& settings);

// Tests of all regions in all channels, each by the errors of both sides. A side of a single replicate is taken for the truth.
Judgement judged(const Replicates& expected, const Replicates& measured, const EqualitySettings& settings);

// The same, of which `regions` are tested: the whole image first. The squared bias is tested too where there is one.
// Neither source of errors is `none`.
Judgement judged(const EstimatedImage& expected, const EstimatedImage& measured,
                 const std::vector<Region>& regions, const EqualitySettings& settings);

}  // namespace umbral
