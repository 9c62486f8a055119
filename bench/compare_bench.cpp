// A comparison of two large images: FLIP alone, and all statistics of files.
#include <benchmark/benchmark.h>

#include <cstdlib>
#include <filesystem>
#include <random>

#include "analysis/comparison.h"
#include "analysis/estimated_file.h"
#include "image/exr.h"

namespace umbral {
namespace {

constexpr int width = 1920, height = 1080;

ExrImage noise(std::uint64_t seed) {
  ExrImage exr{width, height, 0, 0, width, height, {}, {}};
  std::mt19937 engine(static_cast<std::mt19937::result_type>(seed));
  std::exponential_distribution<float> brightness(2);
  for (const char* name : {"B", "G", "R", "stderr.B", "stderr.G", "stderr.R"}) {
    ExrChannel channel{name, std::vector<float>(static_cast<std::size_t>(width) * height)};
    for (float& value : channel.pixels) value = brightness(engine);
    exr.channels.push_back(std::move(channel));
  }
  exr.attributes["umbral:replicates"] = 8;
  exr.attributes["umbral:seeds"] = std::to_string(seed);
  exr.attributes["umbral:integrator"] = std::string("path()");
  return exr;
}

// Both files of the benchmarks, in the directory for temporary files.
struct Files {
  std::string a = path("a"), b = path("b");
  Files() {
    write_exr(a, noise(1));
    write_exr(b, noise(2));
  }
  ~Files() {
    std::filesystem::remove(a);
    std::filesystem::remove(b);
  }
  static std::string path(const std::string& name) {
    return (std::filesystem::temp_directory_path() / ("umbral-bench-" + name + ".exr")).string();
  }
};

void read_image(benchmark::State& state) {
  const Files files;
  for (auto _ : state) benchmark::DoNotOptimize(read_estimated_file(files.a));
}
BENCHMARK(read_image)->Unit(benchmark::kMillisecond)->UseRealTime();

void flip_of_images(benchmark::State& state) {
  const Files files;
  const Planes a = read_estimated_file(files.a).image.mean, b = read_estimated_file(files.b).image.mean;
  for (auto _ : state) benchmark::DoNotOptimize(flip(a, b));
}
BENCHMARK(flip_of_images)->Unit(benchmark::kMillisecond)->UseRealTime();

void all_statistics(benchmark::State& state) {
  const Files files;
  const EstimatedImage a = read_estimated_file(files.a).image, b = read_estimated_file(files.b).image;
  for (auto _ : state) benchmark::DoNotOptimize(compared(a, b, {}));
}
BENCHMARK(all_statistics)->Unit(benchmark::kMillisecond)->UseRealTime();

// What a user waits for: the program from the command to its last line.
void whole_program(benchmark::State& state) {
  const Files files;
  const std::string command = std::string(UMBRAL_PROGRAM " compare --quiet ") + files.a + " " + files.b;
  for (auto _ : state)
    if (std::system(command.c_str()) < 0) state.SkipWithError("no shell");
}
BENCHMARK(whole_program)->Unit(benchmark::kMillisecond)->UseRealTime();

}  // namespace
}  // namespace umbral

BENCHMARK_MAIN();
