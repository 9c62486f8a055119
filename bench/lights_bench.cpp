// Ten thousand lights: relMSE · time of choosing by the light tree, by power, and all alike.
#include <sys/resource.h>

#include <array>
#include <cmath>
#include <cstdlib>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "bench_scenes.h"
#include "core/parallel.h"
#include "integrators/path.h"
#include "render/renderer.h"

namespace umbral::bench {
namespace {

constexpr int size = 96;

double cpu_seconds() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return static_cast<double>(usage.ru_utime.tv_sec + usage.ru_stime.tv_sec) +
         1e-6 * static_cast<double>(usage.ru_utime.tv_usec + usage.ru_stime.tv_usec);
}

struct Image {
  std::vector<double> pixels;
  double seconds;  // of processors
};

// `depth` 0 is no limit.
Image image(const Scene& scene, LightSelection selection, int depth, std::uint64_t seed, int spp) {
  PathIntegrator path;
  path.light_choice = selection;
  path.max_depth = depth;
  RenderOptions options;
  options.film = {size, size, FilterKind::box, 0};
  options.sampling = {spp, 8, SamplerKind::sobol, seed};
  const double before = cpu_seconds();
  const RenderResult result = render(scene, path, options);
  Image image{{}, cpu_seconds() - before};
  for (int i = 0; i < size * size; ++i) {
    const auto rgb = result.film->at(i % size, i / size).mean;
    image.pixels.push_back(
        (static_cast<double>(rgb.x) + static_cast<double>(rgb.y) + static_cast<double>(rgb.z)) / 3);
  }
  return image;
}

// Mean over the pixels of d²/(reference² + 0.01 m²), m the mean of the reference.
double relative_mse(const Image& image, const Image& reference) {
  double mean = 0, sum = 0;
  for (const double r : reference.pixels) mean += r / (size * size);
  for (std::size_t i = 0; i < image.pixels.size(); ++i) {
    const double r = reference.pixels[i];
    sum += sqr(image.pixels[i] - r) / (r * r + 0.01 * mean * mean);
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

// How many samples each rule affords in the time that the tree takes for `spp` is found by a first run; then all get
// about the same time, and what is left of the difference is divided out.
void run(int depth, int spp, int runs, int reference_spp) {
  const Scene scene(hall_of_lights());
  const Image reference = image(scene, LightSelection::tree, depth, 1000, reference_spp);
  constexpr std::array selections{LightSelection::tree, LightSelection::power, LightSelection::uniform};
  std::array<int, 3> samples{};
  double budget = 0;
  for (const LightSelection selection : selections) {
    const double seconds = image(scene, selection, depth, 999, spp).seconds;
    if (selection == LightSelection::tree) budget = seconds;
    samples[static_cast<std::size_t>(selection)] =
        std::max(8, 8 * static_cast<int>(std::lround(spp * budget / seconds / 8)));
  }
  fmt::print("{}: reference {} spp by the tree, {} runs in turn of {:.2g} s of processors\n",
             depth == 1 ? "direct light" : "all light", reference_spp, runs, budget);
  std::array<std::vector<double>, 3> errors, costs;
  for (int i = 0; i < runs; ++i)
    for (const LightSelection selection : selections) {
      const auto k = static_cast<std::size_t>(selection);
      const Image made = image(scene, selection, depth, static_cast<std::uint64_t>(i), samples[k]);
      errors[k].push_back(relative_mse(made, reference));
      costs[k].push_back(errors[k].back() * made.seconds);
    }
  for (std::size_t k = 0; k < 3; ++k) {
    std::vector<double> ratios;
    for (std::size_t i = 0; i < costs[k].size(); ++i) ratios.push_back(costs[0][i] / costs[k][i]);
    fmt::print("{:<8} {:4} spp  relMSE {}  tree/{} at equal time {}\n", EnumNames<LightSelection>::names[k],
               samples[k], Spread(errors[k]).text(), EnumNames<LightSelection>::names[k],
               Spread(ratios).text());
  }
}

}  // namespace
}  // namespace umbral::bench

int main(int argc, char** argv) {
  const int spp = argc > 1 ? std::atoi(argv[1]) : 32;
  const int runs = argc > 2 ? std::atoi(argv[2]) : 5;
  const int reference = argc > 3 ? std::atoi(argv[3]) : 4096;
  for (const int depth : {1, 0}) umbral::bench::run(depth, spp, runs, reference);
}
