// Lists of vertices and faces.
#include "formats/toml/mesh.h"

#include <fmt/format.h>

#include "formats/meshes/triangulate.h"

namespace umbral::toml_file {
namespace {

// A list of lists of N finite numbers.
template <int N>
bool read_vectors(TableReader& table, const char* key, const Value& value,
                  std::vector<glm::vec<N, float>>& vectors) {
  const auto* items = value.as<Value::Array>();
  if (!items) {
    table.wrong_type(key, value, fmt::format("a list of lists of {} numbers", N));
    return false;
  }
  for (const Value& item : *items) {
    const auto* numbers = item.as<Value::Array>();
    bool good = numbers && numbers->size() == N;
    glm::vec<N, float> vector(0.0f);
    for (int i = 0; good && i < N; ++i) {
      vector[i] = static_cast<float>((*numbers)[static_cast<std::size_t>(i)].number().value_or(std::nan("")));
      good = std::isfinite(vector[i]);
    }
    if (!good) {
      table.context().error(item, fmt::format("'{}' of 'mesh' must hold lists of {} finite numbers", key, N));
      return false;
    }
    vectors.push_back(vector);
  }
  return true;
}

bool read_face(TableReader& table, const Value& face, Mesh& mesh) {
  const auto* corners = face.as<Value::Array>();
  if (!corners || corners->size() < 3) {
    table.context().error(face, "a face must be a list of at least 3 vertex numbers");
    return false;
  }
  std::vector<std::uint32_t> polygon;
  for (const Value& corner : *corners) {
    const auto* index = corner.as<std::int64_t>();
    const auto count = static_cast<std::int64_t>(mesh.positions.size());
    if (!index || *index < 0 || *index >= count) {
      const std::string what = index ? fmt::format("vertex {}", *index) : std::string(corner.type_name());
      table.context().error(
          corner, fmt::format("a face names {}, but vertices are numbered 0 to {}", what, count - 1));
      return false;
    }
    polygon.push_back(static_cast<std::uint32_t>(*index));
  }
  if (triangulate(polygon, mesh.positions, mesh.triangles)) return true;
  table.context().error(
      face, fmt::format("a concave face cannot have more than {} corners", largest_concave_polygon));
  return false;
}

template <int N>
bool read_per_vertex(TableReader& table, const char* key, const Mesh& mesh,
                     std::vector<glm::vec<N, float>>& vectors) {
  const Value* value = table.find(key);
  if (!value) return true;
  if (!read_vectors(table, key, *value, vectors)) return false;
  if (vectors.size() == mesh.positions.size()) return true;
  table.context().error(*value, fmt::format("'{}' of 'mesh' has {} entries for {} vertices", key,
                                            vectors.size(), mesh.positions.size()));
  return false;
}

// Linear red, green and blue of each vertex.
bool read_colors(TableReader& table, Mesh& mesh) {
  std::vector<Vec3> colors;
  if (!read_per_vertex(table, "colors", mesh, colors)) return false;
  for (const Vec3& color : colors) mesh.colors.emplace_back(color, 1);
  return true;
}

}  // namespace

bool read_written_mesh(TableReader& table, Mesh& mesh) {
  const Value* vertices = table.find("vertices");
  const Value* faces = table.find("faces");
  if (!vertices && !faces) {
    table.context().diagnostics.error(table.place(), "'mesh' needs a 'file', or 'vertices' and 'faces'");
    return false;
  }
  if (!vertices) table.missing("vertices");
  if (!faces) table.missing("faces");
  if (!vertices || !faces || !read_vectors(table, "vertices", *vertices, mesh.positions)) return false;
  bool good = read_per_vertex(table, "uvs", mesh, mesh.uvs);
  good &= read_per_vertex(table, "uvs1", mesh, mesh.uvs1);
  good &= read_per_vertex(table, "normals", mesh, mesh.normals);
  good &= read_colors(table, mesh);
  const auto* list = faces->as<Value::Array>();
  if (!list) {
    table.wrong_type("faces", *faces, "a list of lists of vertex numbers");
    return false;
  }
  for (const Value& face : *list) good &= read_face(table, face, mesh);
  return good;
}

void refuse_written_mesh(TableReader& table) {
  for (const char* key : {"vertices", "faces", "uvs", "uvs1", "normals", "colors"})
    if (const Entry* entry = table.find_entry(key))
      table.context().error(*entry, fmt::format("'{}' has no effect in a mesh that has a 'file'", key));
}

}  // namespace umbral::toml_file
