// Bytes a second of the readers of meshes: glTF (.glb) and STL, as whole scenes.
#include <benchmark/benchmark.h>

#include <cstring>
#include <filesystem>
#include <fstream>

#include <fmt/format.h>

#include "app/load_scene.h"

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

void load(benchmark::State& state, const char* name, std::string (*bytes)()) {
  const std::filesystem::path path = std::filesystem::temp_directory_path() / name;
  const std::string content = bytes();
  std::ofstream(path, std::ios::binary) << content;
  for (auto _ : state) benchmark::DoNotOptimize(load_scene(path.string()));
  state.SetBytesProcessed(static_cast<std::int64_t>(state.iterations() * content.size()));
  std::filesystem::remove(path);
}
BENCHMARK_CAPTURE(load, glb, "umbral-bench.glb", glb)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(load, stl, "umbral-bench.stl", stl)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace umbral
