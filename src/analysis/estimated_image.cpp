// Errors of regions from errors of pixels or from replicates.
#include "analysis/estimated_image.h"

#include "core/parallel.h"

namespace umbral {
namespace {

constexpr double luminance_weights[3] = {0.2126, 0.7152, 0.0722};

// Sums over the pixels of a region.
template <class Value>
double sum_over(const Region& region, int width, const Value& value) {
  double sum = 0;
  for (int y = region.y0; y < region.y1; ++y) {
    const std::size_t row = static_cast<std::size_t>(y) * static_cast<std::size_t>(width);
    double row_sum = 0;
    for (int x = region.x0; x < region.x1; ++x) row_sum += value(row + static_cast<std::size_t>(x));
    sum += row_sum;
  }
  return sum;
}

// Of independent pixels: Var = Σ v/n², ν = (Σ v)²/(Σ v²/ν_pixel).
MeanEstimate of_pixels(const EstimatedImage& image, const Region& region, const auto& mean,
                       const auto& variance) {
  const auto n = static_cast<double>(region.pixels());
  MeanEstimate estimate{sum_over(region, image.mean.width, mean) / n};
  if (image.source != ErrorSource::pixels) return estimate;
  const double sum = sum_over(region, image.mean.width, variance);
  const double squares = sum_over(region, image.mean.width, [&](std::size_t i) { return sqr(variance(i)); });
  estimate.variance = sum / sqr(n);
  if (squares > 0) estimate.degrees_of_freedom = sqr(sum) / squares * image.degrees_of_freedom;
  return estimate;
}

std::vector<Vec3d> means_of(const Planes& planes, const std::vector<Region>& regions) {
  std::vector<Vec3d> means(regions.size());
  parallel_for(3 * regions.size(), [&](std::size_t task) {
    const std::size_t r = task / 3;
    const int c = static_cast<int>(task % 3);
    const std::vector<float>& values = planes.channels[c];
    const double sum = sum_over(regions[r], planes.width, [&](std::size_t i) { return values[i]; });
    means[r][c] = sum / static_cast<double>(regions[r].pixels());
  });
  return means;
}

}  // namespace

MeanEstimate mean_of(const EstimatedImage& image, std::size_t region, const Region& where, int channel) {
  if (image.source == ErrorSource::replicates) return image.region_means.estimate(region, channel);
  const std::vector<float>& mean = image.mean.channels[channel];
  const std::vector<float>& variance = image.variance.channels[channel];
  return of_pixels(
      image, where, [&](std::size_t i) { return mean[i]; }, [&](std::size_t i) { return variance[i]; });
}

MeanEstimate luminance_of(const EstimatedImage& image, std::size_t region, const Region& where) {
  if (image.source == ErrorSource::replicates) return image.region_luminances.estimate(region, 0);
  const auto weighted = [&](const Planes& planes, std::size_t i, const auto& f) {
    double sum = 0;
    for (int c = 0; c < 3; ++c) sum += luminance_weights[c] * f(static_cast<double>(planes.channels[c][i]));
    return sum;
  };
  return of_pixels(
      image, where, [&](std::size_t i) { return weighted(image.mean, i, [](double m) { return m; }); },
      [&](std::size_t i) { return sqr(weighted(image.variance, i, [](double v) { return std::sqrt(v); })); });
}

ReplicateSum::ReplicateSum(int width, int height, std::vector<Region> regions)
    : image_{Planes(width, height)}, squares_(width, height) {
  image_.region_means.regions = regions;
  image_.region_luminances.regions = std::move(regions);
}

// Welford's running moments per pixel [1962], and running means of the groups.
void ReplicateSum::add(const Planes& replicate) {
  const int n = ++image_.replicates;
  const auto group = static_cast<std::size_t>((n - 1) % EstimatedImage::most_groups);
  if (image_.groups.size() <= group) {
    image_.groups.emplace_back(image_.mean.width, image_.mean.height);
    image_.group_sizes.push_back(0);
  }
  const int size = ++image_.group_sizes[group];
  const auto rows = static_cast<std::size_t>(image_.mean.height);
  const auto width = static_cast<std::size_t>(image_.mean.width);
  parallel_for(3 * rows, [&](std::size_t task) {
    const std::size_t c = task / rows, begin = task % rows * width;
    for (std::size_t i = begin; i < begin + width; ++i) {
      const float x = replicate.channels[c][i];
      float &mean = image_.mean.channels[c][i], &of_group = image_.groups[group].channels[c][i];
      const float delta = x - mean;
      mean += delta / static_cast<float>(n);
      squares_.channels[c][i] += delta * (x - mean);
      of_group += (x - of_group) / static_cast<float>(size);
    }
  });
  const std::vector<Vec3d>& means =
      image_.region_means.means.emplace_back(means_of(replicate, image_.region_means.regions));
  std::vector<Vec3d>& luminances = image_.region_luminances.means.emplace_back();
  for (const Vec3d& m : means)
    luminances.emplace_back(m.r * luminance_weights[0] + m.g * luminance_weights[1] +
                            m.b * luminance_weights[2]);
}

EstimatedImage ReplicateSum::finish() {
  const int n = image_.replicates;
  image_.degrees_of_freedom = n - 1;
  if (n < 2) {
    image_.groups.clear();
    return std::move(image_);
  }
  image_.source = ErrorSource::replicates;
  const float scale = 1 / (static_cast<float>(n) * static_cast<float>(n - 1));
  for (std::vector<float>& channel : squares_.channels)
    for (float& square : channel) square *= scale;
  image_.variance = std::move(squares_);
  return std::move(image_);
}

}  // namespace umbral
