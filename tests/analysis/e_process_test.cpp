// The wager against energy gain: false alarms bounded at all times together, and found gains in the time published.
#include "analysis/e_process.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <random>
#include <vector>

namespace umbral::test {
namespace {

double uniform(std::mt19937_64& random) { return static_cast<double>(random() >> 11) * 0x1p-53; }

struct Kind {
  const char* name;
  double (*draw)(std::mt19937_64&);
  double mean;
  double published;  // median samples until a gain of 2 % is found at 1e-3
  int runs;
};

const Kind kinds[] = {
    {"uniform", uniform, 0.5, 18e3, 41},
    {"lognormal", [](std::mt19937_64& r) { return std::exp(1.5 * std::normal_distribution<double>()(r)); },
     std::exp(1.125), 384e3, 15},
    {"firefly", [](std::mt19937_64& r) { return uniform(r) + (uniform(r) < 1e-3 ? 100 : 0); }, 0.6, 1.26e6,
     15},
};

class EnergyGainTest : public testing::TestWithParam<Kind> {};

// Ville's bound: the chance ever to reach 20 is at most 5 %, here for 3000 looks a run.
TEST_P(EnergyGainTest, RarelyCriesWolfHoweverOftenOneLooks) {
  const Kind& kind = GetParam();
  constexpr int runs = 1000;
  int alarms = 0;
  for (int run = 0; run < runs; ++run) {
    std::mt19937_64 random(1000 + run);
    EnergyGain gain(kind.mean);
    for (int i = 0; i < 3000; ++i) gain.add(kind.draw(random));
    alarms += gain.rejects(0.05);
  }
  EXPECT_LE(alarms, runs * 0.05 + 3.3 * std::sqrt(runs * 0.05 * 0.95));
  testing::Test::RecordProperty("alarms_of_1000_at_5_percent", alarms);
}

// The median of 15 runs spreads by about a fifth of itself.
TEST_P(EnergyGainTest, FindsAGainOfTwoPercentInTheTimePublished) {
  const Kind& kind = GetParam();
  std::vector<double> counts;
  for (int run = 0; run < kind.runs; ++run) {
    std::mt19937_64 random(5000 + run);
    EnergyGain gain(kind.mean / 1.02);
    while (!gain.rejects(1e-3)) {
      gain.add(kind.draw(random));
      ASSERT_LT(gain.count(), 20 * kind.published);
    }
    counts.push_back(static_cast<double>(gain.count()));
  }
  std::sort(counts.begin(), counts.end());
  const double median = counts[counts.size() / 2];
  EXPECT_GT(median, 0.5 * kind.published);
  EXPECT_LT(median, 2 * kind.published);
  testing::Test::RecordProperty("median", std::to_string(median));
}

INSTANTIATE_TEST_SUITE_P(Kinds, EnergyGainTest, testing::ValuesIn(kinds),
                         [](const auto& tested) { return tested.param.name; });

// By hand: one number twice the mean wins half of each stake: mean over k of 1 + 2⁻ᵏ.
TEST(EnergyGain, WealthByHand) {
  EnergyGain gain(2);
  EXPECT_EQ(gain.wealth(), 1);
  gain.add(4);
  EXPECT_DOUBLE_EQ(gain.wealth(), 1 + (1 - std::ldexp(1.0, -14)) / 14);
  EXPECT_DOUBLE_EQ(gain.most(), gain.wealth());
  gain.add(0);  // loses: the most it ever was remains
  EXPECT_LT(gain.wealth(), gain.most());
  EXPECT_EQ(gain.count(), 2u);
}

}  // namespace
}  // namespace umbral::test
