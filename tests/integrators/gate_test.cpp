// Calibration of the gate on synthetic data: false alarms, power, and what it does with either.
#include "support/gate.h"

#include <random>

#include "core/statistics.h"

namespace umbral::test {
namespace {

constexpr int size = 8, tiles = 2;
constexpr double sigma = 0.05;  // of a pixel

PixelImage truth() {
  PixelImage image{size, size, {}};
  for (int i = 0; i < size * size; ++i)
    image.pixels.push_back(Vec3d(1.0 + 0.01 * i, 2.0, 0.5 + 0.02 * (i % size)));
  return image;
}

// Replicates of the truth with normal noise that neighbours share in part, as samplers make them.
class Synthetic {
 public:
  explicit Synthetic(std::uint64_t seed) : engine_(seed) {}

  PixelImage replicate(double gain, double noise = sigma) {
    PixelImage image = truth();
    Vec3d before(0);
    for (Vec3d& pixel : image.pixels) {
      const Vec3d fresh(normal_(engine_), normal_(engine_), normal_(engine_));
      pixel = pixel * gain + noise * (0.8 * fresh + 0.6 * before);
      before = fresh;
    }
    return image;
  }

  std::vector<PixelImage> replicates(double gain = 1) {
    std::vector<PixelImage> images;
    for (int r = 0; r < gate_replicates; ++r) images.push_back(replicate(gain));
    return images;
  }

 private:
  std::mt19937_64 engine_;
  std::normal_distribution<double> normal_;
};

GateSettings settings_at(double alpha) {
  GateSettings settings;
  settings.alpha = alpha;
  settings.tiles = tiles;
  settings.resolution = 0;
  return settings;
}

// k of n is what a probability p gives, but for one case in a thousand to either side.
void expect_binomial(int k, int n, double p) {
  const double spread = 3.3 * std::sqrt(n * p * (1 - p));
  EXPECT_NEAR(k, n * p, spread + 1) << k << " of " << n << " at " << p;
}

TEST(GateCalibration, PValuesOfNullDataAreUniform) {
  constexpr int runs = 2000;
  int below[3] = {0, 0, 0};
  constexpr double levels[3] = {0.5, 0.05, 0.005};
  Synthetic synthetic(1);
  for (int run = 0; run < runs; ++run) {
    const double p = judged(synthetic.replicates(), truth(), settings_at(0.05)).statistics.front().p;
    for (int i = 0; i < 3; ++i) below[i] += p <= levels[i];
  }
  for (int i = 0; i < 3; ++i) expect_binomial(below[i], runs, levels[i]);
}

// Holm's bound is close for statistics that depend on each other as little as these do.
TEST(GateCalibration, FalseAlarmsComeAtTheRateAsked) {
  constexpr int runs = 1000;
  int against_truth = 0, against_each_other = 0;
  Synthetic synthetic(2);
  for (int run = 0; run < runs; ++run) {
    const std::vector<PixelImage> a = synthetic.replicates(), b = synthetic.replicates();
    against_truth += judged(a, truth(), settings_at(0.05)).outcome == Outcome::differs;
    against_each_other += judged(a, b, settings_at(0.05)).outcome == Outcome::differs;
  }
  for (const int alarms : {against_truth, against_each_other}) {
    EXPECT_LE(alarms, 0.05 * runs + 3.3 * std::sqrt(0.05 * 0.95 * runs)) << "of " << runs;
    EXPECT_GE(alarms, 0.03 * runs) << "of " << runs;
  }
  testing::Test::RecordProperty("alarms_of_1000_at_5_percent", against_truth);
}

// A shift as large as the smallest detectable difference that a statistic tells is found in about nine cases of ten
// (a little less: the formula takes the standard error for known).
TEST(GateCalibration, FindsTheSmallestDifferenceItPromises) {
  constexpr int runs = 1000;
  const GateSettings settings = settings_at(1e-3);
  Synthetic synthetic(3);
  const auto green = [&](double gain) {
    return judged(synthetic.replicates(gain), truth(), settings).statistics[1];
  };
  double mde = 0;
  for (int run = 0; run < 100; ++run) mde += green(1).mde / 100;
  ASSERT_GT(mde, 1e-4);
  int found = 0, found_half = 0;
  for (int run = 0; run < runs; ++run) {
    found += green(1 + mde).p <= 1e-3 / 15;
    found_half += green(1 + mde / 2).p <= 1e-3 / 15;
  }
  EXPECT_GE(found, 0.8 * runs);
  EXPECT_LE(found_half, 0.3 * runs);
  testing::Test::RecordProperty("found_of_1000", found);
}

TEST(GateCalibration, OneAlarmIsRepeatedTwoAreAFailure) {
  Synthetic synthetic(4);
  const auto wrong_once = [&](std::uint64_t, int effort) {
    return synthetic.replicate(effort == 1 ? 1.5 : 1, 1e-3 / effort);
  };
  const auto wrong_always = [&](std::uint64_t, int effort) {
    return synthetic.replicate(1.5, 1e-3 / effort);
  };
  EXPECT_TRUE(agrees_with(truth(), wrong_once, settings_at(1e-5)));
  EXPECT_FALSE(agrees_with(truth(), wrong_always, settings_at(1e-5)));
}

TEST(GateCalibration, WhatIsTooNoisyToTellFails) {
  Synthetic synthetic(5);
  const auto noisy = [&](std::uint64_t, int) { return synthetic.replicate(1, 0.5); };
  EXPECT_EQ(judged(synthetic.replicates(), truth(), settings_at(1e-5)).outcome, Outcome::underpowered);
  EXPECT_FALSE(agrees_with(truth(), noisy, settings_at(1e-5)));
  const auto quieter_with_effort = [&](std::uint64_t, int effort) {
    return synthetic.replicate(1, 0.02 / std::sqrt(effort));
  };
  int repeated = 0;
  const auto counted = [&](std::uint64_t seed, int effort) {
    repeated += effort > 1;
    return quieter_with_effort(seed, effort);
  };
  EXPECT_TRUE(agrees_with(truth(), counted, settings_at(1e-5)));
  EXPECT_EQ(repeated, gate_replicates);
}

TEST(GateCalibration, RareBrightReplicatesAreInconclusive) {
  Synthetic synthetic(6);
  std::vector<PixelImage> images;
  for (int r = 0; r < gate_replicates; ++r) images.push_back(synthetic.replicate(r == 5 ? 1.01 : 1, 1e-5));
  EXPECT_EQ(judged(images, truth(), settings_at(1e-5)).outcome, Outcome::skewed);
}

TEST(GateCalibration, DarknessMustBeExact) {
  const PixelImage dark{1, 1, {Vec3d(0)}}, glimmer{1, 1, {Vec3d(1e-9)}};
  GateSettings settings;
  settings.tiles = 1;
  const std::vector<PixelImage> darkness(2, dark), glimmers(2, glimmer);
  EXPECT_EQ(judged(darkness, dark, settings).outcome, Outcome::agrees);
  EXPECT_EQ(judged(glimmers, dark, settings).outcome, Outcome::differs);
}

// Every gated experiment is a test of a suite whose name ends in "Oracle" or "Agreement".
TEST(GateCalibration, AlphaIsSharedAmongEnoughExperiments) {
  const testing::UnitTest& all = *testing::UnitTest::GetInstance();
  int experiments = 0;
  for (int i = 0; i < all.total_test_suite_count(); ++i) {
    const std::string name = all.GetTestSuite(i)->name();
    if (name.ends_with("Oracle") || name.ends_with("Agreement"))
      experiments += all.GetTestSuite(i)->total_test_count();
  }
  EXPECT_GT(experiments, 0);
  EXPECT_LE(experiments, most_experiments);
  testing::Test::RecordProperty("experiments", experiments);
}

}  // namespace
}  // namespace umbral::test
