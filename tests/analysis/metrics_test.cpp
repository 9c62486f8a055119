// Metrics by hand, and what noise does to them.
#include "analysis/metrics.h"

#include <gtest/gtest.h>

#include "support/random.h"

namespace umbral {
namespace {

EstimatedImage flat(float value) {
  EstimatedImage image{Planes(2, 2)};
  for (std::vector<float>& channel : image.mean.channels) std::fill(channel.begin(), channel.end(), value);
  return image;
}

TEST(Metrics, AreWhatTheirDefinitionsSay) {
  const std::vector<Metric> m = metrics(flat(0.5f), flat(0.7f));
  EXPECT_NEAR(m[0].value, 0.04, 1e-7);
  EXPECT_NEAR(m[1].value, 0.04 / 0.26, 1e-6);
  EXPECT_NEAR(m[2].value, 0.04 / (0.51 * 0.51), 1e-6);
  EXPECT_NEAR(m[3].value, 0.2 / 0.51, 1e-6);
  EXPECT_NEAR(m[4].value, 0.2 / 1.21, 1e-6);
  for (const Metric& metric : m) {
    EXPECT_TRUE(std::isnan(metric.debiased)) << metric.name;
    EXPECT_TRUE(std::isnan(metric.of_noise)) << metric.name;
  }
}

// Image and reference of one mean 0.5 and variances 0.02 and 0.01: the image's own error is 0.02.
TEST(Metrics, NoiseOfTheReferenceIsTakenOut) {
  test::Random random(3);
  const auto noisy = [&](double variance) {
    EstimatedImage image{Planes(256, 256), ErrorSource::pixels, Planes(256, 256)};
    for (int c = 0; c < 3; ++c)
      for (std::size_t i = 0; i < image.mean.pixels(); ++i) {
        double sum = -6;  // twelve uniform numbers: variance 1
        for (int k = 0; k < 12; ++k) sum += random.number();
        image.mean.channels[c][i] = static_cast<float>(0.5 + std::sqrt(variance) * sum);
        image.variance.channels[c][i] = static_cast<float>(variance);
      }
    return image;
  };
  const EstimatedImage reference = noisy(0.01), image = noisy(0.02);
  const std::vector<Metric> m = metrics(reference, image);
  EXPECT_NEAR(m[0].value, 0.03, 0.0005);
  EXPECT_NEAR(m[0].debiased, 0.02, 0.0005);
  EXPECT_NEAR(m[0].of_noise, 0.03, 1e-6);
  for (const Metric& metric : {m[3], m[4]})  // all there is, is noise
    EXPECT_NEAR(metric.value / metric.of_noise, 1, 0.02) << metric.name;
}

}  // namespace
}  // namespace umbral
