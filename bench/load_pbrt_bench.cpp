// How fast the text of pbrt files is read, bytes a second on one thread.
#include <benchmark/benchmark.h>

#include <unistd.h>

#include <filesystem>
#include <fstream>

#include <fmt/format.h>

#include "app/load_scene.h"
#include "core/parallel.h"

namespace umbral {
namespace {

// A wavy sheet of n × n vertices with normals and uv, as text.
std::string pbrt_text(int n) {
  std::string points, normals, uvs, indices;
  for (int j = 0; j < n; ++j)
    for (int i = 0; i < n; ++i) {
      const double u = i / (n - 1.0), v = j / (n - 1.0);
      points += fmt::format("{:.6f} {:.6f} {:.6f}\n", u, v, 0.1 * std::sin(20 * u) * std::cos(17 * v));
      normals += fmt::format("{:.6f} {:.6f} {:.6f}\n", 0.2 * u, 0.1 * v, 1.0);
      uvs += fmt::format("{:.6f} {:.6f}\n", u, v);
      if (i + 1 < n && j + 1 < n)
        indices += fmt::format("{} {} {} {} {} {}\n", j * n + i, j * n + i + 1, (j + 1) * n + i,
                               j * n + i + 1, (j + 1) * n + i + 1, (j + 1) * n + i);
    }
  return "WorldBegin\nShape \"trianglemesh\"\n\"point3 P\" [\n" + points + "]\n\"normal N\" [\n" + normals +
         "]\n\"point2 uv\" [\n" + uvs + "]\n\"integer indices\" [\n" + indices + "]\n";
}

void read_pbrt(benchmark::State& state) {
  const std::filesystem::path path =
      std::filesystem::temp_directory_path() / fmt::format("umbral-bench-{}.pbrt", getpid());
  const std::string text = pbrt_text(600);
  std::ofstream(path) << text;
  const ThreadLimit one(1);
  for (auto _ : state) benchmark::DoNotOptimize(load_scene(path.string()));
  state.SetBytesProcessed(static_cast<std::int64_t>(text.size()) * state.iterations());
  std::filesystem::remove(path);
}
BENCHMARK(read_pbrt)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace umbral
