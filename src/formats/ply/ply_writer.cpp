// Vertices and triangles behind a PLY header.
#include "formats/ply/ply_writer.h"

#include <bit>

#include <fmt/format.h>

#include "image/atomic_file.h"

namespace umbral {
namespace {

static_assert(std::endian::native == std::endian::little);

std::string header_of(const Mesh& mesh) {
  std::string text =
      fmt::format("ply\nformat binary_little_endian 1.0\nelement vertex {}\n", mesh.positions.size());
  const auto add = [&](std::initializer_list<const char*> names) {
    for (const char* name : names) text += fmt::format("property float {}\n", name);
  };
  add({"x", "y", "z"});
  if (!mesh.normals.empty()) add({"nx", "ny", "nz"});
  if (!mesh.uvs.empty()) add({"u", "v"});
  if (!mesh.uvs1.empty()) add({"u1", "v1"});
  if (!mesh.colors.empty()) add({"red", "green", "blue", "alpha"});
  return text + fmt::format("element face {}\nproperty list uchar uint vertex_indices\nend_header\n",
                            mesh.triangles.size());
}

template <class T>
void append(std::string& bytes, const T& value) {
  bytes.append(reinterpret_cast<const char*>(&value), sizeof(value));
}

template <class T>
void append_if_any(std::string& bytes, const std::vector<T>& values, std::size_t i) {
  if (!values.empty()) append(bytes, values[i]);
}

}  // namespace

void write_ply(const std::string& path, const Mesh& mesh) {
  std::string bytes = header_of(mesh);
  for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
    append(bytes, mesh.positions[i]);
    append_if_any(bytes, mesh.normals, i);
    append_if_any(bytes, mesh.uvs, i);
    append_if_any(bytes, mesh.uvs1, i);
    append_if_any(bytes, mesh.colors, i);
  }
  for (const glm::uvec3& triangle : mesh.triangles) {
    bytes += '\3';
    append(bytes, triangle);
  }
  write_file(path, bytes);
}

}  // namespace umbral
