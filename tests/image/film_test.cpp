// What a film says of its pixels and of the image, against data whose distribution is known.
#include "image/film.h"

#include <array>
#include <cmath>
#include <stdexcept>

#include <gtest/gtest.h>

#include "core/parallel.h"
#include "core/statistics.h"
#include "support/stability.h"
#include "synthetic_film.h"

namespace umbral {
namespace {

using test::add_normal_block, test::binomial_bounds, test::true_mean;

TEST(Film, MeanAndStandardErrorByHand) {
  Film film({.width = 2, .height = 1, .replicates = 2});
  const std::array<Spectrum, 2> sums{rgb(2, 0, 8), rgb(6, 0, 8)};
  film.add(1, 0, {sums, 2});
  const PixelEstimate estimate = film.at(1, 0);
  EXPECT_EQ(estimate.mean, Vec3d(2, 0, 4));            // replicate means 1 and 3, 0 and 0, 4 and 4
  EXPECT_EQ(estimate.standard_error, Vec3d(1, 0, 0));  // √(2/(2·1)) for the first
  EXPECT_EQ(estimate.samples, 4);
}

TEST(Film, BlocksAddUp) {
  Film film({.width = 1, .height = 1, .replicates = 2});
  const std::array<Spectrum, 2> first{grey(3), grey(1)}, second{grey(5), grey(1)};
  film.add(0, 0, {first, 3});
  film.add(0, 0, {second, 1});
  EXPECT_EQ(film.at(0, 0).mean, Vec3d(1.25));  // of 2 and 0.5
  EXPECT_EQ(film.at(0, 0).standard_error, Vec3d(0.75));
  EXPECT_EQ(film.at(0, 0).samples, 8);
}

TEST(Film, NothingIsKnownWithoutSamplesOrWithOneReplicate) {
  Film film({.width = 2, .height = 1, .replicates = 1});
  EXPECT_EQ(film.at(0, 0).samples, 0);
  EXPECT_EQ(film.at(0, 0).mean, Vec3d(0));
  EXPECT_TRUE(std::isinf(film.at(0, 0).standard_error.r));
  EXPECT_TRUE(std::isinf(film.image_error().half_width()));
  EXPECT_TRUE(std::isinf(film.image_error().relative()));
  const std::array<Spectrum, 1> sums{grey(4)};
  film.add(0, 0, {sums, 2});
  EXPECT_EQ(film.at(0, 0).mean, Vec3d(2));
  EXPECT_TRUE(std::isinf(film.at(0, 0).standard_error.r));
  EXPECT_EQ(film.image_error().mean, 2);
  EXPECT_EQ(film.image_error().pixels, 1u);
  EXPECT_TRUE(std::isinf(film.image_error().rms_standard_error));
  EXPECT_TRUE(std::isinf(film.image_error().half_width()));
}

TEST(Film, PixelsAreNamedInTheFullImage) {
  Film film({.width = 10, .height = 8, .x0 = 4, .y0 = 3, .x1 = 7, .y1 = 5, .replicates = 2});
  EXPECT_EQ(film.layout().pixels(), 6u);
  for (int y = 3; y < 5; ++y)
    for (int x = 4; x < 7; ++x) {
      const std::array<Spectrum, 2> sums{grey(static_cast<float>(10 * y + x)),
                                         grey(static_cast<float>(10 * y + x))};
      film.add(x, y, {sums, 1});
    }
  for (int y = 3; y < 5; ++y)
    for (int x = 4; x < 7; ++x) EXPECT_EQ(film.at(x, y).mean, Vec3d(10 * y + x));
}

TEST(Film, RefusesBrokenLayouts) {
  EXPECT_THROW(Film({.width = 0, .height = 4}), std::invalid_argument);
  EXPECT_THROW(Film({.width = 4, .height = 4, .replicates = 0}), std::invalid_argument);
  EXPECT_THROW(Film({.width = 4, .height = 4, .x0 = 2, .x1 = 2, .y1 = 4}), std::invalid_argument);
  EXPECT_THROW(Film({.width = 4, .height = 4, .x1 = 5, .y1 = 4}), std::invalid_argument);
  EXPECT_THROW(Film({.width = 4, .height = 4, .x0 = -1, .x1 = 2, .y1 = 4}), std::invalid_argument);
}

TEST(Film, LayersAndAuxiliaryFeaturesAreMeans) {
  Film film({.width = 1, .height = 1, .replicates = 2, .layers = {"direct", "indirect"}, .auxiliary = true});
  EXPECT_TRUE(std::isinf(film.auxiliary(0, 0).depth));
  const std::array<Spectrum, 2> sums{grey(1), grey(1)}, layers{rgb(4, 8, 0), rgb(0, 0, 2)};
  AuxiliarySums auxiliary{rgb(1, 2, 3), {0, 0, 3}, 30, 3};
  film.add(0, 0, {sums, 2, layers, auxiliary});
  EXPECT_EQ(film.layer(0, 0, 0), Vec3d(1, 2, 0));
  EXPECT_EQ(film.layer(1, 0, 0), Vec3d(0, 0, 0.5));
  const AuxiliaryPixel pixel = film.auxiliary(0, 0);
  EXPECT_EQ(pixel.albedo, Vec3(0.25f, 0.5f, 0.75f));
  EXPECT_EQ(pixel.normal, Vec3(0, 0, 0.75f));
  EXPECT_EQ(pixel.depth, 10);  // of the three samples that hit something
}

// Student's intervals from the film cover the truth as often as they say. The wrong quantile, 1.96, would
// cover 90.9 % and is far outside of the bounds, so the test can tell.
TEST(Film, IntervalsCoverTheTruth) {
  const FilmLayout layout{.width = 96, .height = 96};
  Film film(layout);
  std::mt19937_64 random(1);
  for (int block = 0; block < 3; ++block) add_normal_block(film, 16, 0.3, random);
  const double t = student_quantile(0.95, layout.replicates - 1);
  int covered = 0, covered_by_normal = 0;
  for (int y = 0; y < 96; ++y)
    for (int x = 0; x < 96; ++x)
      for (int c = 0; c < 3; ++c) {
        const PixelEstimate estimate = film.at(x, y);
        const double deviation = std::abs(estimate.mean[c] - true_mean(x, y, c)) / estimate.standard_error[c];
        covered += deviation <= t;
        covered_by_normal += deviation <= 1.96;
      }
  const auto [low, high] = binomial_bounds(3 * 96 * 96, 0.95);
  EXPECT_GE(covered, low);
  EXPECT_LE(covered, high);
  EXPECT_LT(covered_by_normal, low - 500);
}

// E[SE²] = σ²/R per block, halved when the blocks double. χ² with 3·7·64² degrees of freedom: 5 sigma are 1.9
// %.
TEST(Film, StandardErrorsAreUnbiasedAndScale) {
  Film film({.width = 64, .height = 64});
  std::mt19937_64 random(2);
  const double sigma = 0.3;
  for (const int blocks : {1, 2, 4}) {
    while (film.at(0, 0).samples < 8 * 16 * blocks) add_normal_block(film, 16, sigma, random);
    const ImageError error = film.image_error();
    EXPECT_NEAR(error.pixel_variance() / (sigma * sigma / (8 * blocks)), 1, 0.019) << blocks;
    EXPECT_EQ(error.samples, 64 * 64 * 8 * 16 * blocks);
    EXPECT_EQ(error.pixels, 64u * 64u);
    EXPECT_DOUBLE_EQ(error.relative(), error.rms_standard_error / error.mean);
  }
}

TEST(Film, ImageErrorIsThatOfTheReplicatesOfTheWholeImage) {
  const FilmLayout layout{.width = 7, .height = 5, .x0 = 1, .y0 = 2, .x1 = 7, .y1 = 5, .replicates = 4};
  Film film(layout);
  std::mt19937_64 random(3);
  std::uniform_real_distribution<float> uniform;
  std::array<double, 4> image{};
  double pixels = 0;
  for (int y = 2; y < 5; ++y)
    for (int x = 1; x < 7; ++x) {
      if (x == 3) continue;  // pixels without samples do not count
      ++pixels;
      const std::uint32_t samples = 1 + static_cast<std::uint32_t>(x);  // nor need all have equally many
      std::array<Spectrum, 4> sums;
      for (int r = 0; r < 4; ++r) {
        for (int c = 0; c < 3; ++c) sums[r][c] = uniform(random);
        image[r] += (double{sums[r].r} + sums[r].g + sums[r].b) / samples;
      }
      film.add(x, y, {sums, samples});
    }
  Moments moments;
  for (const double sum : image) moments.add(sum / (3 * pixels));
  const ImageError error = film.image_error();
  EXPECT_NEAR(error.mean, moments.mean, 1e-14);
  EXPECT_NEAR(error.standard_error, moments.standard_error(), 1e-14);
  EXPECT_EQ(error.degrees_of_freedom, 3);
  EXPECT_NEAR(error.half_width(), 3.182446305 * moments.standard_error(), 1e-9);
  EXPECT_EQ(error.pixels, 15u);
}

// What all pixels of a replicate have in common averages out over replicates only: an error bar of the image
// made from those of the pixels would be 8 times too small here.
TEST(Film, ImageIntervalsCoverTheTruthEvenWherePixelsAreCorrelated) {
  std::mt19937_64 random(4);
  std::normal_distribution<float> normal;
  int covered = 0;
  constexpr int films = 1000;
  for (int i = 0; i < films; ++i) {
    Film film({.width = 8, .height = 8});
    std::array<Spectrum, 8> sums;
    for (Spectrum& sum : sums) sum = grey(5 + normal(random));
    for (int pixel = 0; pixel < 64; ++pixel) film.add(pixel % 8, pixel / 8, {sums, 1});
    const ImageError error = film.image_error();
    covered += std::abs(error.mean - 5) <= error.half_width();
  }
  const auto [low, high] = binomial_bounds(films, 0.95);
  EXPECT_GE(covered, low);
  EXPECT_LE(covered, high);
}

// 10⁸ samples of 0.1f in blocks of 64: a sum in single precision stands still long before.
TEST(Film, ManyBlocksKeepTheirDigits) {
  Film film({.width = 1, .height = 1, .replicates = 2});
  const std::array<Spectrum, 2> sums{grey(64 * 0.1f), grey(64 * 0.1f)};
  for (int i = 0; i < 781'250; ++i) film.add(0, 0, {sums, 64});
  EXPECT_NEAR(film.at(0, 0).mean.r / double{0.1f}, 1, 1e-12);
  EXPECT_LT(film.at(0, 0).standard_error.r, 1e-12);
  test::record({"Accumulation", "1e8 samples of a constant drift", "≤ 1e-12 relative",
                fmt::format("{:.1e}", std::abs(film.at(0, 0).mean.r / double{0.1f} - 1)), "mitsuba2 #82"});
}

TEST(Film, ManyThreadsGiveTheBitsOfOne) {
  const FilmLayout layout{.width = 64, .height = 32};
  const auto filled = [&](int threads) {
    const ThreadLimit limit(threads);
    auto film = std::make_unique<Film>(layout);
    parallel_for(64 * 32, [&](std::size_t pixel) {
      std::mt19937_64 random(pixel);
      std::uniform_real_distribution<float> uniform;
      for (int block = 0; block < 5; ++block) {
        std::array<Spectrum, 8> sums;
        for (Spectrum& sum : sums) sum = rgb(uniform(random), 0.5f, uniform(random));
        film->add(static_cast<int>(pixel % 64), static_cast<int>(pixel / 64), {sums, 3});
      }
    });
    return film;
  };
  const auto one = filled(1), many = filled(4);
  for (int y = 0; y < 32; ++y)
    for (int x = 0; x < 64; ++x) {
      EXPECT_EQ(one->at(x, y).mean, many->at(x, y).mean);
      EXPECT_EQ(one->at(x, y).standard_error, many->at(x, y).standard_error);
    }
  EXPECT_EQ(one->image_error().standard_error, many->image_error().standard_error);
  EXPECT_EQ(one->image_error().mean, many->image_error().mean);
}

TEST(Film, RejectedSamplesAreCountedAndTheFirstKept) {
  Film film({.width = 100, .height = 100});
  EXPECT_EQ(film.rejected(), 0u);
  // A permutation of the pixels, from many threads: whichever comes first, the report is the same.
  parallel_for(10'000, [&](std::size_t i) {
    const int pixel = static_cast<int>(i * 7919 % 10'000);
    film.reject({pixel % 100, pixel / 100, 1, i, grey(-1)});
  });
  EXPECT_EQ(film.rejected(), 10'000u);
  const std::vector<RejectedSample> first = film.first_rejected();
  ASSERT_EQ(first.size(), 16u);
  for (int i = 0; i < 16; ++i) {
    EXPECT_EQ(first[i].x, i);
    EXPECT_EQ(first[i].y, 0);
    EXPECT_EQ(first[i].index * 7919 % 10'000, static_cast<std::uint64_t>(i));
    EXPECT_EQ(first[i].value.r, -1);
  }
}

}  // namespace
}  // namespace umbral
