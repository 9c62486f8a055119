// Products of differences, by pairs of groups or by pixels.
#include "analysis/squared_bias.h"

#include "core/parallel.h"
#include "core/statistics.h"

namespace umbral {
namespace {

// The groups of replicates folded into `count`, each weighted by how many it is made of; the truth is the same in all.
Planes folded(const EstimatedImage& image, int count, int group) {
  if (image.source == ErrorSource::exact) return image.mean;
  Planes sum(image.mean.width, image.mean.height);
  int replicates = 0;
  for (auto g = static_cast<std::size_t>(group); g < image.groups.size();
       g += static_cast<std::size_t>(count))
    replicates += image.group_sizes[g];
  for (auto g = static_cast<std::size_t>(group); g < image.groups.size();
       g += static_cast<std::size_t>(count)) {
    const float weight = static_cast<float>(image.group_sizes[g]) / static_cast<float>(replicates);
    for (int c = 0; c < 3; ++c)
      for (std::size_t i = 0; i < sum.pixels(); ++i)
        sum.channels[c][i] += weight * image.groups[g].channels[c][i];
  }
  return sum;
}

double product(const Planes& a, const Planes& b) {
  const auto rows = static_cast<std::size_t>(a.height), width = static_cast<std::size_t>(a.width);
  std::vector<double> sums(rows);
  parallel_for(rows, [&](std::size_t y) {
    for (int c = 0; c < 3; ++c)
      for (std::size_t i = y * width; i < (y + 1) * width; ++i)
        sums[y] += static_cast<double>(a.channels[c][i]) * b.channels[c][i];
  });
  double sum = 0;
  for (const double s : sums) sum += s;
  return sum / (3 * static_cast<double>(a.pixels()));
}

std::optional<SquaredBias> by_groups(const EstimatedImage& a, const EstimatedImage& b) {
  std::size_t groups = EstimatedImage::most_groups;
  for (const EstimatedImage* image : {&a, &b})
    if (image->source == ErrorSource::replicates) groups = std::min(groups, image->groups.size());
  if (groups < 4) return std::nullopt;
  const int count = static_cast<int>(groups);
  std::vector<Planes> differences(groups);
  parallel_for(groups, [&](std::size_t g) {
    differences[g] = folded(b, count, static_cast<int>(g));
    const Planes of_a = folded(a, count, static_cast<int>(g));
    for (int c = 0; c < 3; ++c)
      for (std::size_t i = 0; i < of_a.pixels(); ++i) differences[g].channels[c][i] -= of_a.channels[c][i];
  });
  Moments products;
  for (std::size_t g = 0; g < groups; ++g)
    for (std::size_t h = 0; h < g; ++h) products.add(product(differences[g], differences[h]));
  return SquaredBias{products.mean, products.standard_error(), static_cast<double>(products.n - 1)};
}

SquaredBias by_pixels(const EstimatedImage& a, const EstimatedImage& b) {
  const auto rows = static_cast<std::size_t>(a.mean.height), width = static_cast<std::size_t>(a.mean.width);
  std::vector<Moments> moments(rows);
  parallel_for(rows, [&](std::size_t y) {
    for (std::size_t i = y * width; i < (y + 1) * width; ++i) {
      double sum = 0;
      for (int c = 0; c < 3; ++c) {
        sum += sqr(static_cast<double>(b.mean.channels[c][i]) - a.mean.channels[c][i]);
        for (const EstimatedImage* image : {&a, &b})
          if (image->source == ErrorSource::pixels) sum -= image->variance.channels[c][i];
      }
      moments[y].add(sum / 3);
    }
  });
  Moments all;
  for (const Moments& row : moments) all = combined(all, row);
  return {all.mean, all.standard_error(), static_cast<double>(all.n - 1)};
}

}  // namespace

std::optional<SquaredBias> squared_bias(const EstimatedImage& a, const EstimatedImage& b) {
  const auto either = [&](ErrorSource source) { return a.source == source || b.source == source; };
  if (either(ErrorSource::none)) return std::nullopt;
  if (!either(ErrorSource::replicates)) return by_pixels(a, b);
  if (either(ErrorSource::pixels)) return std::nullopt;
  return by_groups(a, b);
}

}  // namespace umbral
