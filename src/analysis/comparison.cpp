// The parts of a comparison, one after the other.
#include "analysis/comparison.h"

#include <limits>

#include "core/parallel.h"

namespace umbral {
namespace {

constexpr int smallest_tile = 16, most_tiles = 16;  // pixels a side; a side of the image

bool is_known(const EstimatedImage& image) { return image.source != ErrorSource::none; }

// r = b/a − 1,  Var r ≈ (v_b + (b/a)² v_a)/a²
Change change(const Region& region, const MeanEstimate& a, const MeanEstimate& b, bool known) {
  Change c{region, a.value, b.value};
  const double ratio = b.value / a.value;
  c.value = a.value != 0 ? ratio - 1 : std::numeric_limits<double>::quiet_NaN();
  c.half_width = infinity;
  if (!known || a.value == 0) return c;
  MeanEstimate of_a = a;
  of_a.variance *= sqr(ratio);
  c.half_width = difference(of_a, b).error.half_width(0.95) / std::abs(a.value);
  return c;
}

// What a display shows, without the sRGB encoding: FLIP takes it linear.
Planes shown(const Planes& image, const ComparisonSettings& settings) {
  Planes result(image.width, image.height);
  const auto width = static_cast<std::size_t>(image.width);
  parallel_for(static_cast<std::size_t>(image.height), [&](std::size_t y) {
    for (std::size_t i = y * width; i < (y + 1) * width; ++i) {
      const Spectrum c = tone_mapped(rgb(image.channels[0][i], image.channels[1][i], image.channels[2][i]),
                                     settings.exposure, settings.tone_map);
      for (int k = 0; k < 3; ++k) result.channels[k][i] = c[k];
    }
  });
  return result;
}

std::optional<UniformityTest> uniformity_of(const Judgement& judgement) {
  std::vector<double> p;
  for (std::size_t i = 0; i < judgement.statistics.size(); ++i) {
    const Statistic& s = judgement.statistics[i];
    if (s.kind == StatisticKind::tile && i % 3 == 1 && s.error.standard_error() > 0) p.push_back(s.p);
  }
  if (p.size() < 16) return std::nullopt;
  return test_of_uniformity(std::move(p));
}

}  // namespace

std::vector<Region> tested_regions(int width, int height) {
  const auto tiles_of = [](int size) { return std::clamp(size / smallest_tile, 1, most_tiles); };
  return image_and_tiles(width, height, tiles_of(width), tiles_of(height));
}

std::vector<Region> regions_of(int width, int height, const ComparisonSettings& settings) {
  std::vector<Region> regions = tested_regions(width, height);
  regions.insert(regions.end(), settings.regions.begin(), settings.regions.end());
  return regions;
}

Comparison compared(const EstimatedImage& a, const EstimatedImage& b, const ComparisonSettings& settings) {
  const int width = a.mean.width, height = a.mean.height;
  Comparison result;
  result.tiles = tested_regions(width, height);
  const bool known = is_known(a) && is_known(b);
  if (known) {
    result.judgement = judged(a, b, result.tiles, settings.equality);
    result.uniformity = uniformity_of(*result.judgement);
  }
  result.metrics = metrics(a, b);
  result.flip = flip(shown(a.mean, settings), shown(b.mean, settings));
  result.mean_flip = mean(result.flip);
  const std::vector<Region> regions = regions_of(width, height, settings);
  const auto change_of = [&](std::size_t r) {
    return change(regions[r], luminance_of(a, r, regions[r]), luminance_of(b, r, regions[r]), known);
  };
  result.image = change_of(0);
  for (std::size_t r = result.tiles.size(); r < regions.size(); ++r) result.changes.push_back(change_of(r));
  return result;
}

Plane z_map(const EstimatedImage& a, const EstimatedImage& b) {
  if (a.variance.empty() && b.variance.empty()) return Plane(0, 0);
  constexpr float weights[3] = {0.2126f, 0.7152f, 0.0722f};
  Plane z(a.mean.width, a.mean.height);
  const auto width = static_cast<std::size_t>(z.width);
  parallel_for(static_cast<std::size_t>(z.height), [&](std::size_t y) {
    for (std::size_t i = y * width; i < (y + 1) * width; ++i) {
      float difference = 0, deviation = 0;
      for (int c = 0; c < 3; ++c) {
        difference += weights[c] * (b.mean.channels[c][i] - a.mean.channels[c][i]);
        float variance = 0;
        for (const EstimatedImage* image : {&a, &b})
          if (!image->variance.empty()) variance += image->variance.channels[c][i];
        deviation += weights[c] * std::sqrt(variance);
      }
      z.values[i] = difference == 0 ? 0 : difference / deviation;
    }
  });
  return z;
}

}  // namespace umbral
