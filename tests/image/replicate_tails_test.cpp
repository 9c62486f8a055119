// Fireflies and heavy tails on data whose distribution is known: false alarms, power, and what the index promises.
#include "image/replicate_tails.h"

#include <gtest/gtest.h>

#include <functional>
#include <random>
#include <vector>

#include <fmt/format.h>

#include "core/statistics.h"
#include "image/film_image.h"
#include "image/pooled_error.h"
#include "synthetic_film.h"

namespace umbral::test {
namespace {

using Draw = double (*)(std::mt19937_64&);

double uniform(std::mt19937_64& random) { return static_cast<double>(random() >> 11) * 0x1p-53; }
double normal(std::mt19937_64& random) { return 5 + std::normal_distribution<double>()(random); }
double exponential(std::mt19937_64& random) { return std::exponential_distribution<double>()(random); }
double lognormal(std::mt19937_64& random) {
  return std::exp(1.5 * std::normal_distribution<double>()(random));
}
double bernoulli(std::mt19937_64& random) { return uniform(random) < 0.01 ? 1 : 0; }
double firefly(std::mt19937_64& random) { return uniform(random) + (uniform(random) < 1e-3 ? 100 : 0); }

std::vector<Vec3d> pixel(Draw draw, int samples, std::mt19937_64& random, int replicates = 8) {
  std::vector<Vec3d> means;
  for (int r = 0; r < replicates; ++r) {
    double sum = 0;
    for (int i = 0; i < samples; ++i) sum += draw(random);
    means.push_back(Vec3d(sum / samples));
  }
  return means;
}

// Of normal replicates, one pixel in 10⁵ at most.
TEST(Fireflies, AreNotSeenInPlainNoise) {
  const FireflyTest is_firefly(8);
  std::mt19937_64 random(1);
  int alarms = 0;
  for (int i = 0; i < 300'000; ++i) alarms += is_firefly(pixel(normal, 1, random));
  EXPECT_LE(alarms, 10);
}

// Where exactly one sample of 512 was the rare one, its pixel is found; where none was, nothing is.
TEST(Fireflies, AreFoundWhereTheyAre) {
  const FireflyTest is_firefly(8);
  std::mt19937_64 random(2);
  int with = 0, found = 0, without = 0, wrong = 0;
  for (int i = 0; i < 20'000; ++i) {
    const std::vector<Vec3d> means = pixel(firefly, 64, random);
    int bright = 0;
    for (const Vec3d& mean : means) bright += mean.x > 1.3;
    const bool flag = is_firefly(means);
    with += bright == 1;
    found += bright == 1 && flag;
    without += bright == 0;
    wrong += bright == 0 && flag;
  }
  EXPECT_GT(with, 5000);
  EXPECT_GE(found, 0.995 * with);
  EXPECT_GT(without, 5000);
  EXPECT_LE(wrong, 5);
}

TEST(Fireflies, NeedFourReplicatesAndDarknessHasNone) {
  EXPECT_FALSE(FireflyTest(3)(std::vector<Vec3d>{Vec3d(0), Vec3d(0), Vec3d(9)}));
  EXPECT_TRUE(FireflyTest(4)(std::vector<Vec3d>{Vec3d(0), Vec3d(0), Vec3d(9), Vec3d(0)}));
  EXPECT_FALSE(FireflyTest(4)(std::vector<Vec3d>(4, Vec3d(0))));
  EXPECT_FALSE(FireflyTest(4)(std::vector<Vec3d>(4, Vec3d(0.3))));
  // Far from the others, but of no weight: not worth a word.
  EXPECT_FALSE(FireflyTest(4)(std::vector<Vec3d>{Vec3d(1), Vec3d(1), Vec3d(1), Vec3d(1.1)}));
}

struct Case {
  const char* name;
  Draw draw;
  double mean;
  int samples;  // a replicate
  int replicates = 8;
};

const Case cases[] = {{"uniform_1", uniform, 0.5, 1},
                      {"exponential_1", exponential, 1, 1},
                      {"exponential_16", exponential, 1, 16},
                      {"lognormal_16", lognormal, std::exp(1.125), 16},
                      {"lognormal_1024", lognormal, std::exp(1.125), 1024},
                      {"bernoulli_16", bernoulli, 0.01, 16},
                      {"bernoulli_256", bernoulli, 0.01, 256},
                      {"firefly_16", firefly, 0.6, 16},
                      {"firefly_4096", firefly, 0.6, 4096},
                      {"uniform_1_of_32", uniform, 0.5, 1, 32},
                      {"exponential_16_of_4", exponential, 1, 16, 4},
                      {"firefly_16_of_32", firefly, 0.6, 16, 32},
                      {"lognormal_4_of_32", lognormal, std::exp(1.125), 4, 32}};

class Tails : public testing::TestWithParam<Case> {};

// The index parts images whose intervals hold from those whose intervals do not, without knowing the truth.
TEST_P(Tails, TheIndexTellsWhetherIntervalsHold) {
  const Case& c = GetParam();
  const int pixels = std::min(10'000, 16'000'000 / c.samples / c.replicates);
  const double t = student_quantile(0.95, c.replicates - 1);
  std::mt19937_64 random(3);
  TailSums tails;
  int covered = 0, too_low = 0;
  for (int i = 0; i < pixels; ++i) {
    const std::vector<Vec3d> means = pixel(c.draw, c.samples, random, c.replicates);
    tails.add(means);
    Moments moments;
    for (const Vec3d& mean : means) moments.add(mean.x);
    const double off = moments.mean - c.mean;
    covered += std::abs(off) <= t * moments.standard_error();
    too_low += off < -t * moments.standard_error();
  }
  const double coverage = 1.0 * covered / pixels;
  fmt::print("  tail index {:.2f}, coverage {:.1f} %, {:.0f} % of the misses too low\n", tails.index(),
             100 * coverage, 100.0 * too_low / std::max(1, pixels - covered));
  const double slack = 3.3 * std::sqrt(0.07 * 0.93 / pixels);
  if (tails.index() > heavy_tail_index)
    EXPECT_LT(coverage, 0.935 + slack);
  else
    EXPECT_GT(coverage, 0.93 - slack);
}

INSTANTIATE_TEST_SUITE_P(Kinds, Tails, testing::ValuesIn(cases),
                         [](const auto& tested) { return tested.param.name; });

// Of even noise, pooled errors are the true one within 5 %, single ones within 27 %.
TEST(PooledError, IsSteadierThanThatOfAPixel) {
  Film film({.width = 64, .height = 64});
  std::mt19937_64 random(4);
  add_normal_block(film, 16, 0.3, random);
  const FilmImage image = film_image(film, {});
  const std::vector<Vec3d> pooled = pooled_errors(image);
  const double truth = 0.3 / std::sqrt(8.0);
  Moments single, of_neighbours;
  for (std::size_t i = 0; i < pooled.size(); ++i)
    for (int c = 0; c < 3; ++c) {
      single.add(sqr(image.pixels[i].standard_error[c] / truth - 1));
      of_neighbours.add(sqr(pooled[i][c] / truth - 1));
    }
  EXPECT_NEAR(std::sqrt(single.mean), 0.27, 0.02);
  EXPECT_NEAR(std::sqrt(of_neighbours.mean), 0.055, 0.008);
}

TEST(PooledError, ByHandAndWhereSomethingIsMissing) {
  FilmImage image = film_image(Film({.width = 4, .height = 1}), {});
  for (const int x : {0, 1, 3}) image.pixels[static_cast<std::size_t>(x)] = {Vec3d(1), Vec3d(x), 8};
  const std::vector<Vec3d> pooled = pooled_errors(image);
  EXPECT_DOUBLE_EQ(pooled[0].x, std::sqrt((0 + 1) / 2.0));      // x ≤ 2, and pixel 2 has no samples
  EXPECT_DOUBLE_EQ(pooled[2].x, std::sqrt((0 + 1 + 9) / 3.0));  // it takes its neighbours'
  EXPECT_DOUBLE_EQ(pooled[3].x, std::sqrt((1 + 9) / 2.0));
  EXPECT_TRUE(std::isinf(pooled_errors(film_image(Film({.width = 1, .height = 1}), {}))[0].x));
}

}  // namespace
}  // namespace umbral::test
