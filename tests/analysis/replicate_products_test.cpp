// Variance, error and bias out of inner products are what they are defined to be, and unbiased.
#include "analysis/replicate_products.h"

#include <gtest/gtest.h>

#include "analysis/synthetic_replicates.h"
#include "core/statistics.h"

namespace umbral::test {
namespace {

// The definition, pixel by pixel.
double mean_variance(const std::vector<Planes>& images) {
  Moments variances;
  for (std::size_t pixel = 0; pixel < images[0].pixels(); ++pixel)
    for (int c = 0; c < 3; ++c) {
      Moments moments;
      for (const Planes& image : images) moments.add(image.at(pixel)[c]);
      variances.add(moments.variance());
    }
  return variances.mean;
}

TEST(ReplicateProducts, VarianceIsThatOfThePixelsWhateverTheOrigin) {
  Random random(1);
  const auto images = noisy_images(7, 20, 2, 0.3, normal, random);
  const Planes origin = flat_image(20, Vec3d(-5, 3, 100));
  const double expected = mean_variance(images);
  EXPECT_NEAR(ReplicateProducts(images, {}).variance(), expected, 1e-13);
  EXPECT_NEAR(ReplicateProducts(images, origin).variance(), expected, 1e-9);
}

TEST(ReplicateProducts, ErrorIsTheMeanSquaredDistanceFromTheReference) {
  Random random(2);
  const auto images = noisy_images(5, 8, 1, 0.1, normal, random);
  const Planes reference = flat_image(8, Vec3d(1.5));
  double expected = 0;
  for (const Planes& image : images)
    for (std::size_t i = 0; i < 8; ++i) {
      const Vec3d difference = image.at(i) - 1.5;
      expected += dot(difference, difference) / (5 * 8 * 3);
    }
  EXPECT_NEAR(ReplicateProducts(images, reference).error(), expected, 1e-13);
  EXPECT_NEAR(ReplicateProducts(images, reference).error({0.01, 0}), expected - 0.01, 1e-13);
}

// 400 repetitions: the mean of each estimate lies within 4 of its standard errors of the truth, which is 1 in 5000 by
// chance for all three together.
TEST(ReplicateProducts, VarianceErrorAndBiasAreUnbiasedAboutANoisyReference) {
  constexpr double variance = 0.5, noise = 0.2, offset = 0.3;
  Moments v, e, b;
  Random random(3);
  for (int run = 0; run < 400; ++run) {
    const auto images = noisy_images(4, 10, 1 + offset, variance, lognormal(0.5), random);
    const auto reference = noisy_images(1, 10, 1, noise, normal, random)[0];
    const ReplicateProducts products(images, reference);
    v.add(products.variance());
    e.add(products.error({noise, 0}));
    b.add(products.squared_bias({noise, 0}));
  }
  EXPECT_NEAR(v.mean, variance, 4 * v.standard_error());
  EXPECT_NEAR(e.mean, variance + offset * offset, 4 * e.standard_error());
  EXPECT_NEAR(b.mean, offset * offset, 4 * b.standard_error());
  EXPECT_LT(b.standard_error(), 0.02);
}

TEST(ReplicateProducts, AFireflyShowsAsSkewness) {
  Random random(4);
  auto images = noisy_images(16, 50, 1, 0.01, normal, random);
  EXPECT_FALSE(ReplicateProducts(images, {}).log_variance()->skewed());
  images[5].channels[1][7] = 100;
  EXPECT_TRUE(ReplicateProducts(images, {}).log_variance()->skewed());
}

TEST(ReplicateProducts, WhatNoiseOfTheReferenceDrownsHasNoLogarithm) {
  Random random(5);
  const auto images = noisy_images(16, 10, 1, 1e-4, normal, random);
  const ReplicateProducts products(images, flat_image(10, Vec3d(1)));
  EXPECT_TRUE(products.log_error({0, 0}));
  EXPECT_FALSE(products.log_error({1e-2, 0}));
  EXPECT_GT(products.log_error({0, 1e-8})->variance, products.log_error({0, 0})->variance);
}

}  // namespace
}  // namespace umbral::test
