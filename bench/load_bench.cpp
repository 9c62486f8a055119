// Bytes a second on one thread, and memory, of the readers of meshes and of pbrt text, as whole scenes.
#include <benchmark/benchmark.h>

#include <malloc.h>
#include <unistd.h>

#include <cstring>
#include <filesystem>
#include <fstream>
#include <optional>

#include <fmt/format.h>

#include "app/load_scene.h"
#include "core/parallel.h"
#include "scene/scene.h"

namespace umbral {
namespace {

constexpr std::uint32_t side = 700;  // vertices of a grid's edge

// A bumpy grid: positions, normals, uv and 32-bit indices.
struct Grid {
  std::vector<float> vertices;
  std::vector<std::uint32_t> indices;

  Grid() {
    for (std::uint32_t y = 0; y < side; ++y)
      for (std::uint32_t x = 0; x < side; ++x) {
        const float u = static_cast<float>(x) / side, v = static_cast<float>(y) / side;
        vertices.insert(vertices.end(), {u, v, 0.01f * std::sin(90 * u * v), 0, 0, 1, u, v});
      }
    for (std::uint32_t y = 0; y + 1 < side; ++y)
      for (std::uint32_t x = 0; x + 1 < side; ++x) {
        const std::uint32_t a = y * side + x;
        indices.insert(indices.end(), {a, a + 1, a + side, a + 1, a + side + 1, a + side});
      }
  }
};

template <class T>
void append(std::string& bytes, const std::vector<T>& values) {
  bytes.append(reinterpret_cast<const char*>(values.data()), values.size() * sizeof(T));
}

void append(std::string& bytes, std::uint32_t number) { append(bytes, std::vector{number}); }

std::string glb() {
  const Grid grid;
  const std::size_t vertices = grid.vertices.size() * 4, indices = grid.indices.size() * 4;
  std::string json = fmt::format(
      R"({{"asset":{{"version":"2.0"}},"buffers":[{{"byteLength":{}}}],"bufferViews":[
      {{"buffer":0,"byteLength":{},"byteStride":32}},{{"buffer":0,"byteOffset":{},"byteLength":{}}}],"accessors":[
      {{"bufferView":0,"componentType":5126,"count":{},"type":"VEC3"}},
      {{"bufferView":0,"byteOffset":12,"componentType":5126,"count":{},"type":"VEC3"}},
      {{"bufferView":0,"byteOffset":24,"componentType":5126,"count":{},"type":"VEC2"}},
      {{"bufferView":1,"componentType":5125,"count":{},"type":"SCALAR"}}],"nodes":[{{"mesh":0}}],"scenes":[{{"nodes":[0]}}],
      "meshes":[{{"primitives":[{{"attributes":{{"POSITION":0,"NORMAL":1,"TEXCOORD_0":2}},"indices":3}}]}}]}})",
      vertices + indices, vertices, vertices, indices, side * side, side * side, side * side,
      grid.indices.size());
  while (json.size() % 4 != 0) json += ' ';
  std::string bytes = "glTF";
  append(bytes, 2);
  append(bytes, static_cast<std::uint32_t>(28 + json.size() + vertices + indices));
  append(bytes, static_cast<std::uint32_t>(json.size()));
  bytes += "JSON" + json;
  append(bytes, static_cast<std::uint32_t>(vertices + indices));
  append(bytes, 0x004e4942);
  append(bytes, grid.vertices);
  append(bytes, grid.indices);
  return bytes;
}

std::string stl() {
  const Grid grid;
  std::string bytes(80, ' ');
  append(bytes, static_cast<std::uint32_t>(grid.indices.size() / 3));
  for (std::size_t i = 0; i < grid.indices.size(); i += 3) {
    bytes.append(12, '\0');
    for (std::size_t k = 0; k < 3; ++k)
      bytes.append(reinterpret_cast<const char*>(&grid.vertices[8 * grid.indices[i + k]]), 12);
    bytes.append(2, '\0');
  }
  return bytes;
}

std::string ply() {
  const Grid grid;
  std::string bytes = fmt::format(
      "ply\nformat binary_little_endian 1.0\nelement vertex {}\nproperty float x\nproperty float y\n"
      "property float z\nproperty float nx\nproperty float ny\nproperty float nz\nproperty float u\n"
      "property float v\nelement face {}\nproperty list uchar int vertex_indices\nend_header\n",
      side * side, grid.indices.size() / 3);
  append(bytes, grid.vertices);
  for (std::size_t i = 0; i < grid.indices.size(); i += 3) {
    bytes += '\3';
    bytes.append(reinterpret_cast<const char*>(&grid.indices[i]), 12);
  }
  return bytes;
}

// Quads with normals and uv, as modellers write them.
std::string obj() {
  const Grid grid;
  std::string v, vn, vt, f;
  for (std::size_t i = 0; i < grid.vertices.size(); i += 8) {
    const float* p = &grid.vertices[i];
    v += fmt::format("v {:.6f} {:.6f} {:.6f}\n", p[0], p[1], p[2]);
    vn += fmt::format("vn {:.4f} {:.4f} {:.4f}\n", p[3], p[4], p[5]);
    vt += fmt::format("vt {:.6f} {:.6f}\n", p[6], p[7]);
  }
  for (std::uint32_t y = 0; y + 1 < side; ++y)
    for (std::uint32_t x = 0; x + 1 < side; ++x) {
      f += 'f';
      for (const std::uint32_t c :
           {y * side + x, y * side + x + 1, (y + 1) * side + x + 1, (y + 1) * side + x})
        f += fmt::format(" {0}/{0}/{0}", c + 1);
      f += '\n';
    }
  return v + vt + vn + f;
}

std::string pbrt() {
  const Grid grid;
  std::string points, normals, uvs, indices;
  for (std::size_t i = 0; i < grid.vertices.size(); i += 8) {
    const float* p = &grid.vertices[i];
    points += fmt::format("{:.6f} {:.6f} {:.6f}\n", p[0], p[1], p[2]);
    normals += fmt::format("{:.6f} {:.6f} {:.6f}\n", p[3], p[4], p[5]);
    uvs += fmt::format("{:.6f} {:.6f}\n", p[6], p[7]);
  }
  for (std::size_t i = 0; i < grid.indices.size(); ++i)
    indices += fmt::format("{}{}", grid.indices[i], i % 6 == 5 ? '\n' : ' ');
  return "WorldBegin\nShape \"trianglemesh\"\n\"point3 P\" [\n" + points + "]\n\"normal N\" [\n" + normals +
         "]\n\"point2 uv\" [\n" + uvs + "]\n\"integer indices\" [\n" + indices + "]\n";
}

// Of this process, MiB; "VmRSS:" what it has, "VmHWM:" the most that it had since reset_peak().
double memory(const char* what) {
  std::ifstream status("/proc/self/status");
  for (std::string line; std::getline(status, line);)
    if (line.starts_with(what)) return std::stod(line.substr(std::strlen(what))) / 1024;
  return 0;
}

void reset_peak() { std::ofstream("/proc/self/clear_refs") << "5"; }

// What is left when the scene can be rendered, and the most until it was loaded and until then, beyond what there was before.
void measure_memory(benchmark::State& state, const std::string& path) {
  malloc_trim(0);
  reset_peak();
  const double before = memory("VmRSS:");
  LoadedScene loaded = load_scene(path);
  state.counters["loading_MiB"] = memory("VmHWM:") - before;
  const Scene scene(std::move(loaded.file.scene));
  state.counters["peak_MiB"] = memory("VmHWM:") - before;
  malloc_trim(0);
  state.counters["final_MiB"] = memory("VmRSS:") - before;
}

void load(benchmark::State& state, const char* ending, std::string (*bytes)()) {
  const std::string path =
      (std::filesystem::temp_directory_path() / fmt::format("umbral-bench-{}{}", getpid(), ending)).string();
  std::string content = bytes();
  std::ofstream(path, std::ios::binary) << content;
  const std::size_t size = content.size();
  std::string().swap(content);
  const ThreadLimit one(1);
  measure_memory(state, path);
  for (auto _ : state) {
    std::optional<LoadedScene> scene(load_scene(path));
    state.PauseTiming();
    scene.reset();
    state.ResumeTiming();
  }
  state.SetBytesProcessed(static_cast<std::int64_t>(state.iterations() * size));
  state.counters["file_MiB"] = static_cast<double>(size) / (1 << 20);
  std::filesystem::remove(path);
}
BENCHMARK_CAPTURE(load, glb, ".glb", glb)->Unit(benchmark::kMillisecond)->MeasureProcessCPUTime();
BENCHMARK_CAPTURE(load, ply, ".ply", ply)->Unit(benchmark::kMillisecond)->MeasureProcessCPUTime();
BENCHMARK_CAPTURE(load, stl, ".stl", stl)->Unit(benchmark::kMillisecond)->MeasureProcessCPUTime();
BENCHMARK_CAPTURE(load, obj, ".obj", obj)->Unit(benchmark::kMillisecond)->MeasureProcessCPUTime();
BENCHMARK_CAPTURE(load, pbrt, ".pbrt", pbrt)->Unit(benchmark::kMillisecond)->MeasureProcessCPUTime();

}  // namespace
}  // namespace umbral
