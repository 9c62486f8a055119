// Grouping of faces and sharing of vertices.
#include "formats/obj/obj_meshes.h"

#include <algorithm>

#include <fmt/format.h>

#include "formats/meshes/triangulate.h"

namespace umbral {
namespace {

// Gives every different (position, uv, normal) of one mesh a number: a chain of them hangs on each position.
class VertexTable {
 public:
  explicit VertexTable(std::size_t positions) : heads_(positions, Head{0, 0}) {}

  void begin_mesh() {
    ++mesh_;
    vertices_.clear();
  }

  // The vertex's number, and whether it is new.
  std::pair<std::uint32_t, bool> number(const ObjCorner& corner) {
    Head& head = heads_[static_cast<std::size_t>(corner.position)];
    if (head.mesh != mesh_) head = {mesh_, no_vertex};
    for (std::uint32_t i = head.first; i != no_vertex; i = vertices_[i].next)
      if (vertices_[i].uv == corner.uv && vertices_[i].normal == corner.normal) return {i, false};
    const auto added = static_cast<std::uint32_t>(vertices_.size());
    vertices_.push_back({corner.uv, corner.normal, head.first});
    head.first = added;
    return {added, true};
  }

 private:
  static constexpr std::uint32_t no_vertex = 0xffffffffu;
  struct Head {
    std::uint32_t mesh, first;
  };
  struct Vertex {
    std::int32_t uv, normal;
    std::uint32_t next;
  };
  std::vector<Head> heads_;
  std::vector<Vertex> vertices_;
  std::uint32_t mesh_ = 0;
};

struct Group {
  std::vector<std::uint32_t> faces;
  bool has_uvs = false;
};

// One group for each material and for faces with and without normals, in this order.
std::vector<Group> grouped(const ObjFile& file, ObjGrouping grouping) {
  std::vector<Group> groups(2 * (grouping == ObjGrouping::all ? 1 : file.materials.size()));
  for (std::size_t i = 0; i < file.faces.size(); ++i) {
    const std::span<const ObjCorner> corners = file.corners_of(i);
    const bool flat =
        std::any_of(corners.begin(), corners.end(), [](const ObjCorner& c) { return c.normal < 0; });
    const std::size_t first = grouping == ObjGrouping::all ? 0 : 2 * file.faces[i].material;
    Group& group = groups[first + (flat ? 1 : 0)];
    group.faces.push_back(static_cast<std::uint32_t>(i));
    group.has_uvs |=
        std::any_of(corners.begin(), corners.end(), [](const ObjCorner& c) { return c.uv >= 0; });
  }
  return groups;
}

class MeshMaker {
 public:
  MeshMaker(const ObjFile& file, TextErrors& errors)
      : file_(file), errors_(errors), vertices_(file.positions.size()) {}

  ObjMesh make(const Group& group, bool flat) {
    const ObjFace& first = file_.faces[group.faces.front()];
    ObjMesh result{{}, first.material, first.line};
    vertices_.begin_mesh();
    without_uv_ = 0;
    for (const std::uint32_t face : group.faces) add_face(face, flat, group.has_uvs, result.mesh);
    if (without_uv_ > 0)
      errors_.warning(errors_.bare_place(first.line),
                      fmt::format("{} vertices without texture coordinates have (0, 0)", without_uv_));
    return result;
  }

 private:
  void add_face(std::uint32_t face, bool flat, bool has_uvs, Mesh& mesh) {
    polygon_.clear();
    for (ObjCorner corner : file_.corners_of(face)) {
      if (flat) corner.normal = -1;
      const auto [number, is_new] = vertices_.number(corner);
      polygon_.push_back(number);
      if (is_new) add_vertex(corner, has_uvs, mesh);
    }
    if (!triangulate(polygon_, mesh.positions, mesh.triangles))
      errors_.error(errors_.bare_place(file_.faces[face].line),
                    fmt::format("a concave face cannot have more than {} corners", largest_concave_polygon));
  }

  void add_vertex(const ObjCorner& corner, bool has_uvs, Mesh& mesh) {
    mesh.positions.push_back(file_.positions[static_cast<std::size_t>(corner.position)]);
    if (corner.normal >= 0) mesh.normals.push_back(file_.normals[static_cast<std::size_t>(corner.normal)]);
    if (!has_uvs) return;
    mesh.uvs.push_back(corner.uv >= 0 ? file_.uvs[static_cast<std::size_t>(corner.uv)] : Vec2{0, 0});
    without_uv_ += corner.uv < 0 ? 1 : 0;
  }

  const ObjFile& file_;
  TextErrors& errors_;
  VertexTable vertices_;
  std::vector<std::uint32_t> polygon_;
  std::size_t without_uv_ = 0;
};

}  // namespace

std::vector<ObjMesh> obj_meshes(const ObjFile& file, ObjGrouping grouping, TextErrors& errors) {
  std::vector<ObjMesh> meshes;
  const std::vector<Group> groups = grouped(file, grouping);
  MeshMaker maker(file, errors);
  for (std::size_t i = 0; i < groups.size(); ++i)
    if (!groups[i].faces.empty()) meshes.push_back(maker.make(groups[i], i % 2 == 1));
  return meshes;
}

}  // namespace umbral
