// One pass over both images for all metrics.
#include "analysis/metrics.h"

#include <limits>

#include "core/parallel.h"

namespace umbral {
namespace {

constexpr double nothing = std::numeric_limits<double>::quiet_NaN();
constexpr double offset = 0.01;
constexpr int count = 5, squares = 3;  // the first three are of squares

struct Sums {
  double value[count] = {}, debiased[squares] = {}, of_noise[count] = {};

  void add(const Sums& other) {
    for (int m = 0; m < count; ++m) value[m] += other.value[m];
    for (int m = 0; m < count; ++m) of_noise[m] += other.of_noise[m];
    for (int m = 0; m < squares; ++m) debiased[m] += other.debiased[m];
  }
};

// E|d| = √(2/π)·σ of a normal d.
const double mean_deviation = std::sqrt(2 / pi_d);

void add(Sums& sums, double a, double b, double va, double vb) {
  const double d = std::abs(b - a), sigma = std::sqrt(va + vb);
  const double weights[count] = {1, 1 / (a * a + offset), 1 / sqr(std::abs(a) + offset),
                                 1 / (std::abs(a) + offset), 1 / (std::abs(a) + std::abs(b) + offset)};
  for (int m = 0; m < squares; ++m) {
    sums.value[m] += d * d * weights[m];
    sums.debiased[m] += (d * d - va) * weights[m];
    sums.of_noise[m] += (va + vb) * weights[m];
  }
  for (int m = squares; m < count; ++m) {
    sums.value[m] += d * weights[m];
    sums.of_noise[m] += mean_deviation * sigma * weights[m];
  }
}

bool is_known(const EstimatedImage& image) { return image.source != ErrorSource::none; }

}  // namespace

std::vector<Metric> metrics(const EstimatedImage& reference, const EstimatedImage& image) {
  const auto rows = static_cast<std::size_t>(image.mean.height);
  const auto width = static_cast<std::size_t>(image.mean.width);
  const auto variance = [](const EstimatedImage& of, int c, std::size_t i) {
    return of.variance.empty() ? 0.0 : static_cast<double>(of.variance.channels[c][i]);
  };
  std::vector<Sums> sums(rows);
  parallel_for(rows, [&](std::size_t y) {
    for (int c = 0; c < 3; ++c)
      for (std::size_t i = y * width; i < (y + 1) * width; ++i)
        add(sums[y], reference.mean.channels[c][i], image.mean.channels[c][i], variance(reference, c, i),
            variance(image, c, i));
  });
  Sums all;
  for (const Sums& row : sums) all.add(row);
  std::vector<Metric> result{{"MSE", "mean d²"},
                             {"relMSE", "mean d²/(a² + 0.01)"},
                             {"MRSE", "mean d²/(|a| + 0.01)²"},
                             {"MAPE", "mean |d|/(|a| + 0.01)"},
                             {"SMAPE", "mean |d|/(|a| + |b| + 0.01)"}};
  const double n = 3 * static_cast<double>(image.mean.pixels());
  for (int m = 0; m < count; ++m) {
    result[m].value = all.value[m] / n;
    result[m].debiased = m < squares && is_known(reference) ? all.debiased[m] / n : nothing;
    result[m].of_noise = is_known(reference) && is_known(image) ? all.of_noise[m] / n : nothing;
  }
  return result;
}

}  // namespace umbral
