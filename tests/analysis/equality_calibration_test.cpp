// Calibration of comparisons on images with known means: how often they err, and that they see what they promise.
#include <gtest/gtest.h>

#include <fmt/format.h>

#include "analysis/distributions.h"
#include "analysis/equality.h"
#include "analysis/p_values.h"
#include "analysis/squared_bias.h"

namespace umbral::test {
namespace {

constexpr int size = 16;  // pixels a side
constexpr int runs =
    300;  // of everything; a true rate of 5 % gives 1.2 to 8.8 % but for one case in a thousand

const std::vector<Region>& regions() {
  static const std::vector<Region> all = image_and_tiles(size, size, 2, 2);
  return all;
}

// Where the errors come from.
enum class From { replicates, pixels };

// An image whose pixels are means of `samples` draws each, over `replicates`, its mean the distribution's times 1 + `gain`.
class Synthetic {
 public:
  Synthetic(Draw draw, From from, std::uint64_t seed) : draw_(draw), from_(from), random_(seed) {}

  EstimatedImage operator()(double gain = 0) {
    const double shift = gain * mean_of(draw_);
    const int replicates = from_ == From::replicates ? 16 : 8;
    ReplicateSum sum(size, size, regions());
    for (int r = 0; r < replicates; ++r) {
      Planes image(size, size);
      for (std::vector<float>& channel : image.channels)
        for (float& value : channel) value = static_cast<float>(shift + drawn(draw_, random_));
      sum.add(image);
    }
    EstimatedImage image = sum.finish();
    if (from_ == From::pixels) image.source = ErrorSource::pixels;
    return image;
  }

 private:
  Draw draw_;
  From from_;
  Random random_;
};

EqualitySettings settings_at(double alpha) {
  EqualitySettings settings;
  settings.alpha = alpha;
  settings.resolution = 0;
  settings.image_mde = settings.tile_mde = infinity;
  return settings;
}

struct Rates {
  int differs = 0, skewed = 0;
};

Rates rates(Draw draw, From from, double alpha) {
  Synthetic a(draw, from, 11), b(draw, from, 12);
  Rates rates;
  for (int run = 0; run < runs; ++run) {
    const EstimatedImage of_a = a(), of_b = b();
    const Outcome outcome = judged(of_a, of_b, regions(), settings_at(alpha)).outcome;
    rates.differs += outcome == Outcome::differs;
    rates.skewed += outcome == Outcome::skewed;
  }
  return rates;
}

class EqualityCalibration : public testing::TestWithParam<std::tuple<Draw, From>> {};

// At 5 % in all of 16 statistics, and by Holm's bound not more.
TEST_P(EqualityCalibration, FalseAlarmsStayBelowTheirRate) {
  const auto& [draw, from] = GetParam();
  const Rates found = rates(draw, from, 0.05);
  EXPECT_LE(found.differs, 0.05 * runs + 3.1 * std::sqrt(0.05 * 0.95 * runs));
  fmt::print("  | {} | {} | {:.1f} % | {:.0f} % |\n", draw_names[static_cast<int>(draw)],
             from == From::pixels ? "pixels" : "replicates", 100.0 * found.differs / runs,
             100.0 * found.skewed / runs);
}

// A shift as large as what the image's mean promises to see in nine of ten cases, by that statistic alone; of skewed
// noise, whose errors vary with it, in somewhat less.
TEST_P(EqualityCalibration, WhatIsPromisedIsSeen) {
  const auto& [draw, from] = GetParam();
  Synthetic a(draw, from, 21), b(draw, from, 22);
  const auto green = [&](double gain) {
    const EstimatedImage of_a = a(), of_b = b(gain);
    return judged(of_a, of_b, regions(), settings_at(1e-3)).statistics[1];
  };
  double mde = 0;
  for (int run = 0; run < 40; ++run) mde += green(0).mde / 40;
  int found = 0, found_half = 0;
  for (int run = 0; run < runs; ++run) {
    found += green(mde).p <= 1e-3 / 16;
    found_half += green(mde / 2).p <= 1e-3 / 16;
  }
  EXPECT_GE(found, 0.8 * runs) << mde;
  EXPECT_LE(found_half, 0.4 * runs) << mde;
  fmt::print("  | {} | {} | {:.2f} % | {:.0f} % | {:.0f} % |\n", draw_names[static_cast<int>(draw)],
             from == From::pixels ? "pixels" : "replicates", 100 * mde, 100.0 * found / runs,
             100.0 * found_half / runs);
}

INSTANTIATE_TEST_SUITE_P(Table, EqualityCalibration,
                         testing::Combine(testing::Values(Draw::uniform, Draw::lognormal_1,
                                                          Draw::lognormal_1_5, Draw::firefly,
                                                          Draw::bernoulli),
                                          testing::Values(From::replicates, From::pixels)));

// Fireflies that few replicates have met make no verdict of equality.
TEST(Equality, RareFirefliesAreInconclusive) {
  Random random(31);
  const auto image = [&] {
    ReplicateSum sum(size, size, regions());
    for (int r = 0; r < 16; ++r) {
      Planes planes(size, size);
      for (std::vector<float>& channel : planes.channels)
        for (float& value : channel) value = random.number();
      if (r == 5)
        for (std::vector<float>& channel : planes.channels)
          for (std::size_t i = 0; i < channel.size(); i += 7) channel[i] += 100;
      sum.add(planes);
    }
    return sum.finish();
  };
  const EstimatedImage a = image(), b = image();
  EXPECT_EQ(judged(a, b, regions(), settings_at(1e-3)).outcome, Outcome::skewed);
}

// A difference that means of tiles do not have: pixels go up and down in turn.
TEST(SquaredBias, SeesWhatMeansDoNot) {
  for (const From from : {From::replicates, From::pixels}) {
    Synthetic a(Draw::uniform, from, 41), b(Draw::uniform, from, 42);
    int found = 0;
    double mean = 0;
    for (int run = 0; run < 50; ++run) {
      const EstimatedImage of_a = a();
      EstimatedImage of_b = b();
      const auto shift = [](std::size_t i) { return (i + i / size) % 2 ? 0.15f : -0.15f; };
      const auto shifted = [&](Planes& planes) {
        for (std::vector<float>& channel : planes.channels)
          for (std::size_t i = 0; i < channel.size(); ++i) channel[i] += shift(i);
      };
      shifted(of_b.mean);
      for (Planes& group : of_b.groups) shifted(group);
      const Judgement judgement = judged(of_a, of_b, regions(), settings_at(1e-3));
      const Statistic& s = judgement.statistics.back();
      ASSERT_EQ(s.kind, StatisticKind::squared_bias);
      found += s.p < 1e-3 / 16;
      mean += s.measured / 50;
    }
    EXPECT_EQ(found, 50);
    EXPECT_NEAR(mean, 0.15 * 0.15, 0.001);
  }
}

// The pixels of replicates may hang together, those with error bars of their own do not: no spread would be right for
// both, so the verdict is left to the other statistics.
TEST(SquaredBias, IsNotTakenOfErrorsOfTwoKinds) {
  Synthetic a(Draw::uniform, From::replicates, 53), b(Draw::uniform, From::pixels, 54);
  const EstimatedImage of_a = a(), of_b = b();
  EXPECT_FALSE(squared_bias(of_a, of_b));
  const Judgement judgement = judged(of_a, of_b, regions(), settings_at(0.05));
  EXPECT_FALSE(judgement.statistics.empty());
  for (const Statistic& s : judgement.statistics) EXPECT_NE(s.kind, StatisticKind::squared_bias);
}

// Unbiased, and its p-values uniform, where nothing differs.
TEST(SquaredBias, IsZeroOnAverageWithoutADifference) {
  for (const From from : {From::replicates, From::pixels}) {
    Synthetic a(Draw::lognormal_1, from, 51), b(Draw::lognormal_1, from, 52);
    std::vector<double> p;
    for (int run = 0; run < runs; ++run) {
      const EstimatedImage of_a = a(), of_b = b();
      p.push_back(judged(of_a, of_b, regions(), settings_at(0.05)).statistics.back().p);
    }
    int below_5 = 0;
    for (const double x : p) below_5 += x <= 0.05;
    EXPECT_LE(below_5, 0.05 * runs + 3.1 * std::sqrt(0.05 * 0.95 * runs));
    EXPECT_GE(below_5, 1);
    EXPECT_GT(test_of_uniformity(p).p, 1e-3) << (from == From::pixels ? "pixels" : "replicates");
  }
}

}  // namespace
}  // namespace umbral::test
