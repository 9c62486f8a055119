// Combining two renders: what agrees with a single render exactly, what in expectation, and what is refused.
#include "image/film_image.h"

#include <cmath>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/statistics.h"
#include "files.h"
#include "synthetic_film.h"

namespace umbral {
namespace {

using test::add_normal_block, test::binomial_bounds, test::message_of, test::true_mean;
using testing::HasSubstr;

Provenance provenance(std::uint64_t seed) {
  return {.version = "0.1.0",
          .scene = "a.toml",
          .scene_hash = "abc",
          .integrator = "path",
          .sampler = "sobol",
          .filter = "box",
          .seeds = {seed},
          .render_seconds = 2,
          .stop_reason = "samples"};
}

// Samples in blocks of 16 per replicate; the means of the replicates of a block have the deviation sigma.
FilmImage rendered(const FilmLayout& layout, std::uint64_t seed, int blocks, double sigma) {
  Film film(layout);
  std::mt19937_64 random(seed);
  for (int i = 0; i < blocks; ++i) add_normal_block(film, 16, sigma, random);
  return film_image(film, provenance(seed));
}

constexpr double sigma = 0.3;

TEST(FilmImage, HoldsWhatTheFilmSays) {
  Film film(
      {.width = 5, .height = 4, .x0 = 1, .y0 = 1, .x1 = 4, .y1 = 3, .layers = {"a"}, .auxiliary = true});
  std::mt19937_64 random(1);
  add_normal_block(film, 16, sigma, random);
  film.reject({1, 1, 0, 5, grey(-1)});
  const FilmImage image = film_image(film, provenance(1));
  EXPECT_EQ(image.pixels.size(), 6u);
  for (int y = 1; y < 3; ++y)
    for (int x = 1; x < 4; ++x) {
      EXPECT_EQ(image.at(x, y).mean, film.at(x, y).mean);
      EXPECT_EQ(image.at(x, y).standard_error, film.at(x, y).standard_error);
      EXPECT_EQ(image.layers[0][image.layout.index(x, y)], Vec3(film.layer(0, x, y)));
    }
  EXPECT_EQ(image.samples_rejected, 1);
  EXPECT_EQ(image.samples_per_pixel(), 128);
  EXPECT_EQ(image.error.standard_error, film.image_error().standard_error);
  EXPECT_EQ(image.colours()[0].g, static_cast<float>(film.at(1, 1).mean.g));
  const ImageError error = error_of_pixels(image.pixels);
  EXPECT_NEAR(error.mean, image.error.mean, 1e-14);
  EXPECT_NEAR(error.rms_standard_error, image.error.rms_standard_error, 1e-14);
  EXPECT_EQ(error.samples, image.error.samples);
}

TEST(Combined, TwoHalvesHaveTheMeanOfTheWhole) {
  const FilmLayout layout{.width = 6, .height = 4, .layers = {"direct"}};
  Film first(layout), second(layout), whole(layout);
  for (const bool half : {false, true}) {
    std::mt19937_64 random(half ? 11 : 10), again(half ? 11 : 10);
    for (int block = 0; block < (half ? 3 : 1); ++block) {
      add_normal_block(half ? second : first, 16, sigma, random);
      add_normal_block(whole, 16, sigma, again);
    }
  }
  const FilmImage merged = combined(film_image(first, provenance(10)), film_image(second, provenance(11)));
  const FilmImage once = film_image(whole, provenance(12));
  for (std::size_t i = 0; i < once.pixels.size(); ++i) {
    for (int c = 0; c < 3; ++c) EXPECT_NEAR(merged.pixels[i].mean[c] / once.pixels[i].mean[c], 1, 1e-14);
    EXPECT_EQ(merged.pixels[i].samples, once.pixels[i].samples);
    EXPECT_NEAR(merged.layers[0][i].r, once.layers[0][i].r, 1e-6);
  }
  EXPECT_NEAR(merged.error.mean / once.error.mean, 1, 1e-14);
  EXPECT_EQ(merged.error.samples, once.error.samples);
  EXPECT_EQ(merged.samples_per_pixel(), once.samples_per_pixel());
  EXPECT_EQ(merged.layout.replicates, 16);
}

TEST(Combined, ByHand) {
  const PixelEstimate a{Vec3d(1), Vec3d(0.3), 100}, b{Vec3d(3), Vec3d(0.1), 300};
  FilmImage first = rendered({.width = 1, .height = 1}, 1, 1, sigma), second = first;
  second.provenance.seeds = {2};
  first.pixels[0] = a;
  second.pixels[0] = b;
  first.error = {.mean = 1, .standard_error = 0.3, .degrees_of_freedom = 7, .samples = 100, .pixels = 1};
  second.error = {.mean = 3, .standard_error = 0.1, .degrees_of_freedom = 3, .samples = 300, .pixels = 1};
  const FilmImage merged = combined(first, second);
  EXPECT_DOUBLE_EQ(merged.pixels[0].mean.r, 2.5);
  // √(100²·0.3² + 300²·0.1²)/400 = √1800/400
  EXPECT_DOUBLE_EQ(merged.pixels[0].standard_error.r, std::sqrt(1800.0) / 400);
  EXPECT_DOUBLE_EQ(merged.error.standard_error, std::sqrt(1800.0) / 400);
  EXPECT_DOUBLE_EQ(merged.error.mean, 2.5);
  // [Satterthwaite 1946; Welch 1947]: both shares are 900, (900 + 900)²/(900²/7 + 900²/3) = 8.4
  EXPECT_DOUBLE_EQ(merged.error.degrees_of_freedom, 8.4);
}

// Sizes of the parts, how fast the deviation of a replicate falls with its samples, and whether the merge of
// the replicates' moments would do too.
struct MergeCase {
  int first_blocks, second_blocks;
  double
      exponent;  // deviation ∝ samples^−exponent; ½ for independent samples, more for a low-discrepancy set
  bool moments_would_do;
};

// E[SE²] is the variance of the combined mean; 5 sigma of the estimate of it are 1.9 %.
TEST(Combined, StandardErrorsAreUnbiasedForAnySampler) {
  const FilmLayout layout{.width = 64, .height = 64};
  const MergeCase cases[] = {{2, 2, 0.5, true}, {1, 4, 0.5, true}, {1, 4, 1.0, false}, {3, 1, 1.5, false}};
  std::uint64_t seed = 100;
  for (const MergeCase& c : cases) {
    const double sigma_a = sigma * std::pow(c.first_blocks, -c.exponent);
    const double sigma_b = sigma * std::pow(c.second_blocks, -c.exponent);
    const auto part = [&](int blocks, double deviation) {
      Film film(layout);
      std::mt19937_64 random(++seed);
      add_normal_block(film, 16 * blocks, deviation, random);
      return film_image(film, provenance(seed));
    };
    const FilmImage a = part(c.first_blocks, sigma_a), b = part(c.second_blocks, sigma_b);
    const double na = c.first_blocks, nb = c.second_blocks, n = na + nb;
    const double truth = (sqr(na * sigma_a) + sqr(nb * sigma_b)) / (8 * n * n);
    const FilmImage merged = combined(a, b);
    EXPECT_NEAR(merged.error.pixel_variance() / truth, 1, 0.019) << na << ' ' << nb;
    // M2 of 16 replicates weighted by their samples [Chan et al. 1979]; its variance of the mean is M2/(15
    // n).
    double by_moments = 0;
    for (std::size_t i = 0; i < a.pixels.size(); ++i) {
      const auto m2 = [](const PixelEstimate& p) { return sqr(p.standard_error.r) * 8 * 7; };
      const double delta = a.pixels[i].mean.r - b.pixels[i].mean.r;
      by_moments +=
          (na * m2(a.pixels[i]) + nb * m2(b.pixels[i]) + 8 * delta * delta * na * nb / n) / (8 * 15 * n);
    }
    const double bias = std::abs(by_moments / static_cast<double>(a.pixels.size()) / truth - 1);
    if (c.moments_would_do)
      EXPECT_LT(bias, 0.03);
    else
      EXPECT_GT(bias, 0.3);
  }
}

TEST(Combined, IntervalsCoverTheTruth) {
  const FilmLayout layout{.width = 96, .height = 96};
  const FilmImage merged = combined(rendered(layout, 21, 1, sigma), rendered(layout, 22, 1, sigma));
  const double t = student_quantile(0.95, 14);
  int covered = 0;
  for (int y = 0; y < 96; ++y)
    for (int x = 0; x < 96; ++x)
      for (int c = 0; c < 3; ++c) {
        const PixelEstimate& estimate = merged.at(x, y);
        covered += std::abs(estimate.mean[c] - true_mean(x, y, c)) <= t * estimate.standard_error[c];
      }
  // Satterthwaite's degrees of freedom are between 7 and 14, 12.6 on average: up to 0.35 % less than nominal.
  const auto [low, unused] = binomial_bounds(3 * 96 * 96, 0.9465);
  const auto [unused_too, high] = binomial_bounds(3 * 96 * 96, 0.95);
  EXPECT_GE(covered, low);
  EXPECT_LE(covered, high);
}

TEST(Combined, CommutesAndAssociates) {
  const FilmLayout layout{.width = 3, .height = 3};
  const FilmImage a = rendered(layout, 31, 1, sigma), b = rendered(layout, 32, 2, sigma),
                  c = rendered(layout, 33, 5, sigma);
  const FilmImage ab = combined(a, b), ba = combined(b, a);
  const FilmImage left = combined(ab, c), right = combined(a, combined(b, c));
  for (int i = 0; i < 9; ++i)
    for (int k = 0; k < 3; ++k) {
      EXPECT_NEAR(ab.pixels[i].mean[k] / ba.pixels[i].mean[k], 1, 1e-15);
      EXPECT_NEAR(ab.pixels[i].standard_error[k] / ba.pixels[i].standard_error[k], 1, 1e-15);
      EXPECT_NEAR(left.pixels[i].mean[k] / right.pixels[i].mean[k], 1, 1e-14);
      EXPECT_NEAR(left.pixels[i].standard_error[k] / right.pixels[i].standard_error[k], 1, 1e-14);
    }
  EXPECT_NEAR(left.error.standard_error / right.error.standard_error, 1, 1e-14);
  EXPECT_NEAR(left.error.mean / right.error.mean, 1, 1e-14);
}

TEST(Combined, APixelWithoutSamplesTakesTheOther) {
  const FilmLayout layout{.width = 2, .height = 1, .auxiliary = true};
  FilmImage a = rendered(layout, 41, 1, sigma);
  const FilmImage b = rendered(layout, 42, 1, sigma);
  a.pixels[0] = {};
  const FilmImage merged = combined(a, b);
  EXPECT_EQ(merged.pixels[0].mean, b.pixels[0].mean);
  EXPECT_EQ(merged.pixels[0].standard_error, b.pixels[0].standard_error);
  EXPECT_EQ(combined(b, a).pixels[0].mean, b.pixels[0].mean);
}

TEST(Combined, APartWithoutErrorBarsLeavesNone) {
  const FilmImage a = rendered({.width = 2, .height = 1, .replicates = 1}, 51, 1, sigma);
  const FilmImage b = rendered({.width = 2, .height = 1}, 52, 1, sigma);
  const FilmImage merged = combined(a, b);
  EXPECT_TRUE(std::isinf(merged.pixels[0].standard_error.r));
  EXPECT_TRUE(std::isinf(merged.error.half_width()));
  EXPECT_FALSE(std::isnan(merged.error.mean));
}

TEST(Combined, AuxiliaryFeaturesAreWeightedBySamples) {
  const FilmLayout layout{.width = 3, .height = 1, .auxiliary = true};
  FilmImage a = rendered(layout, 61, 1, sigma), b = rendered(layout, 62, 3, sigma);
  a.auxiliary = {{Vec3(1), {0, 0, 1}, 4}, {Vec3(1), {0, 0, 1}, 4}, {}};
  b.auxiliary = {{Vec3(0), {0, 1, 0}, 8}, {}, {}};
  const FilmImage merged = combined(a, b);
  EXPECT_EQ(merged.auxiliary[0].albedo, Vec3(0.25f));
  EXPECT_EQ(merged.auxiliary[0].normal, Vec3(0, 0.75f, 0.25f));
  EXPECT_EQ(merged.auxiliary[0].depth, 7);
  EXPECT_EQ(merged.auxiliary[1].depth, 4);
  EXPECT_TRUE(std::isinf(merged.auxiliary[2].depth));
}

TEST(Combined, ProvenanceTellsOfBoth) {
  FilmImage a = rendered({.width = 1, .height = 1}, 1, 1, sigma),
            b = rendered({.width = 1, .height = 1}, 2, 1, sigma);
  b.provenance.sampler = "independent";
  b.provenance.extra["host"] = "b";
  a.samples_rejected = 2;
  b.samples_rejected = 3;
  const FilmImage merged = combined(a, b);
  EXPECT_EQ(merged.provenance.seeds, (std::vector<std::uint64_t>{1, 2}));
  EXPECT_EQ(merged.provenance.sampler, "sobol and independent");
  EXPECT_EQ(merged.provenance.version, "0.1.0");
  EXPECT_EQ(merged.provenance.render_seconds, 4);
  EXPECT_EQ(merged.provenance.extra.at("host"), "b");
  EXPECT_EQ(merged.samples_rejected, 5);
}

TEST(Combined, RefusesWhatIsNotIndependentOrNotTheSame) {
  const FilmLayout layout{.width = 4, .height = 3};
  const FilmImage a = rendered(layout, 1, 1, sigma), b = rendered(layout, 2, 1, sigma);
  const auto refusal = [&](auto&& change) {
    FilmImage changed = b;
    change(changed);
    return message_of<CombineError>([&] { combined(a, changed); });
  };
  EXPECT_EQ(refusal([](FilmImage&) {}), "");
  EXPECT_EQ(refusal([](FilmImage& i) {
              i.provenance.seeds = {7, 1};
            }),
            "the images cannot be combined: both were made with the seed 1, so they are not independent");
  EXPECT_EQ(refusal([](FilmImage& i) { i.provenance.scene_hash = "def"; }),
            "the images cannot be combined: their scenes differ ('abc' and 'def')");
  EXPECT_EQ(refusal([](FilmImage& i) { i.provenance.integrator = "normals"; }),
            "the images cannot be combined: their integrators differ ('path' and 'normals')");
  EXPECT_THAT(refusal([](FilmImage& i) { i.provenance.filter = "tent"; }), HasSubstr("their filters differ"));
  EXPECT_THAT(refusal([](FilmImage& i) { i.provenance.bias_notes = {"max_depth = 3"}; }),
              HasSubstr("biased"));
  EXPECT_EQ(refusal([](FilmImage& i) { i.layout.width = 5; }),
            "the images cannot be combined: their sizes differ (4 x 3 and 5 x 3)");
  EXPECT_THAT(refusal([](FilmImage& i) { i.layout.x1 = 3; }), HasSubstr("crop windows differ"));
  EXPECT_THAT(refusal([](FilmImage& i) { i.layout.layers = {"direct"}; }), HasSubstr("layers differ"));
}

}  // namespace
}  // namespace umbral
