// Ten thousand lights: relMSE · time of choosing by the light tree, by power, and all alike. Of reflected light, and of
// all that is seen: lamps smaller than a pixel are seen with a noise that no choice among lights can change.
#include <array>
#include <cmath>
#include <cstdlib>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "bench_scenes.h"
#include "core/parallel.h"
#include "cpu_seconds.h"
#include "integrators/path.h"
#include "render/renderer.h"

namespace umbral::bench {
namespace {

constexpr int size = 96;

struct Image {
  std::vector<double> seen, reflected;  // with the lamps themselves, and without
  double seconds;                       // of processors
};

double average(const Vec3d& rgb) { return (rgb.x + rgb.y + rgb.z) / 3; }

// `depth` 0 is no limit.
Image image(const Scene& scene, LightSelection selection, int depth, std::uint64_t seed, int spp) {
  PathIntegrator path;
  path.light_choice = selection;
  path.max_depth = depth;
  RenderOptions options;
  options.film = {size, size, FilterKind::box, 0};
  options.sampling = {spp, 8, SamplerKind::sobol, seed};
  options.layers = true;
  const double before = cpu_seconds();
  const RenderResult result = render(scene, path, options);
  Image image{{}, {}, cpu_seconds() - before};
  for (int i = 0; i < size * size; ++i) {
    const int x = i % size, y = i / size;
    const double reflected = average(result.film->layer(1, x, y)) + average(result.film->layer(2, x, y));
    image.reflected.push_back(reflected);
    image.seen.push_back(reflected + average(result.film->layer(0, x, y)));
  }
  return image;
}

// Mean over the pixels of d²/(reference² + 0.01 m²), m the mean of the reference.
double relative_mse(const std::vector<double>& image, const std::vector<double>& reference) {
  double mean = 0, sum = 0;
  for (const double r : reference) mean += r / (size * size);
  for (std::size_t i = 0; i < image.size(); ++i) {
    const double r = reference[i];
    sum += sqr(image[i] - r) / (r * r + 0.01 * mean * mean);
  }
  return sum / (size * size);
}

struct Spread {
  double mean = 0, low = HUGE_VAL, high = 0;

  explicit Spread(const std::vector<double>& values) {
    for (const double x : values) {
      mean += x / static_cast<double>(values.size());
      low = std::min(low, x);
      high = std::max(high, x);
    }
  }
  std::string text() const { return fmt::format("{:.3g} ({:.3g} … {:.3g})", mean, low, high); }
};

constexpr std::array selections{LightSelection::tree, LightSelection::power, LightSelection::uniform};
using Samples = std::array<int, selections.size()>;

// How many samples each rule affords in the time that the tree takes for `spp`; what is left of the difference in time
// is divided out later.
Samples samples_in_equal_time(const Scene& scene, int depth, int spp) {
  Samples samples{};
  double budget = 0;
  for (std::size_t k = 0; k < selections.size(); ++k) {
    const double seconds = image(scene, selections[k], depth, 999, spp).seconds;
    if (k == 0) budget = seconds;
    samples[k] = std::max(8, 8 * static_cast<int>(std::lround(spp * budget / seconds / 8)));
  }
  return samples;
}

struct Errors {
  std::array<std::vector<double>, selections.size()> relative_mse, cost;

  void add(std::size_t selection, double error, double seconds) {
    relative_mse[selection].push_back(error);
    cost[selection].push_back(error * seconds);
  }

  void print(const char* what, const Samples& samples) const {
    for (std::size_t k = 0; k < selections.size(); ++k) {
      std::vector<double> ratios;
      for (std::size_t i = 0; i < cost[k].size(); ++i) ratios.push_back(cost[0][i] / cost[k][i]);
      const char* name = EnumNames<LightSelection>::names[static_cast<std::size_t>(selections[k])];
      fmt::print("{:<9} {:<8} {:4} spp  relMSE {}  tree/{} at equal time {}\n", what, name, samples[k],
                 Spread(relative_mse[k]).text(), name, Spread(ratios).text());
    }
  }
};

void run(const Scene& scene, int depth, int spp, int runs, int reference_spp) {
  const Image reference = image(scene, LightSelection::tree, depth, 1000, reference_spp);
  const Samples samples = samples_in_equal_time(scene, depth, spp);
  Errors seen, reflected;
  for (int i = 0; i < runs; ++i)
    for (std::size_t k = 0; k < selections.size(); ++k) {
      const Image made = image(scene, selections[k], depth, static_cast<std::uint64_t>(i), samples[k]);
      seen.add(k, relative_mse(made.seen, reference.seen), made.seconds);
      reflected.add(k, relative_mse(made.reflected, reference.reflected), made.seconds);
    }
  fmt::print("{}: reference {} spp by the tree, {} runs in turn\n", depth == 1 ? "direct light" : "all light",
             reference_spp, runs);
  reflected.print("reflected", samples);
  seen.print("seen", samples);
}

}  // namespace
}  // namespace umbral::bench

int main(int argc, char** argv) {
  const int spp = argc > 1 ? std::atoi(argv[1]) : 32;
  const int runs = argc > 2 ? std::atoi(argv[2]) : 3;
  const int reference = argc > 3 ? std::atoi(argv[3]) : 2048;
  const umbral::Scene scene(umbral::bench::hall_of_lights());
  for (const int depth : {1, 0}) umbral::bench::run(scene, depth, spp, runs, reference);
}
