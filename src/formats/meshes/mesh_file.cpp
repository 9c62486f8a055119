// Choice of the reader by the file's name, and OBJ files as one mesh.
#include "formats/meshes/mesh_file.h"

#include <algorithm>
#include <map>

#include <fmt/format.h>

#include "formats/obj/obj_meshes.h"
#include "formats/stl/stl_reader.h"

namespace umbral {
namespace {

// Appends triangles that share no vertices, with their own normals and, where `to` has any, uvs.
void append_flat(Mesh& to, const Mesh& flat) {
  to.uvs.resize(to.uvs.empty() && flat.uvs.empty() ? 0 : to.positions.size(), Vec2{0, 0});
  const bool has_uvs = !to.uvs.empty();
  for (const glm::uvec3& t : flat.triangles) {
    const auto first = static_cast<std::uint32_t>(to.positions.size());
    const Vec3d a(flat.positions[t.x]), b(flat.positions[t.y]), c(flat.positions[t.z]);
    const Vec3d normal = cross(b - a, c - a);
    const double length = glm::length(normal);
    for (int k = 0; k < 3; ++k) {
      to.positions.push_back(flat.positions[t[k]]);
      to.normals.push_back(Vec3(length > 0 ? normal / length : normal));
      if (has_uvs) to.uvs.push_back(flat.uvs.empty() ? Vec2{0, 0} : flat.uvs[t[k]]);
    }
    to.triangles.push_back({first, first + 1, first + 2});
  }
}

std::optional<Mesh> obj_as_one_mesh(SceneBuilder& builder, const std::shared_ptr<const SourceText>& source) {
  TextErrors errors(builder.diagnostics, source);
  const ObjFile file = parse_obj(source->text(), errors);
  if (errors.any()) return std::nullopt;
  std::vector<ObjMesh> meshes = obj_meshes(file, ObjGrouping::all, errors);
  if (errors.any()) return std::nullopt;
  if (meshes.empty()) {
    builder.diagnostics.error({{source->name()}}, "the file has no faces");
    return std::nullopt;
  }
  if (meshes.size() == 2) append_flat(meshes[0].mesh, meshes[1].mesh);
  return std::move(meshes[0].mesh);
}

// By a reader of meshes alone.
template <class Read>
std::optional<Mesh> plain_mesh(SceneBuilder& builder, const std::shared_ptr<const SourceText>& source,
                               const Read& read) {
  try {
    std::vector<std::string> warnings;
    Mesh mesh = read(warnings);
    for (const std::string& warning : warnings) builder.diagnostics.warning({{source->name()}}, warning);
    return mesh;
  } catch (const SceneError& error) {
    builder.diagnostics.adopt(error);
    return std::nullopt;
  }
}

}  // namespace

FileKind file_kind(const std::filesystem::path& path) {
  static const std::map<std::string, FileKind> kinds{{".toml", FileKind::toml}, {".obj", FileKind::obj},
                                                     {".ply", FileKind::ply},   {".stl", FileKind::stl},
                                                     {".gltf", FileKind::gltf}, {".glb", FileKind::gltf},
                                                     {".pbrt", FileKind::pbrt}, {".xml", FileKind::mitsuba}};
  std::string ending = (is_packed(path) ? path.stem() : path).extension().string();
  std::transform(ending.begin(), ending.end(), ending.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  const auto found = kinds.find(ending);
  return found == kinds.end() ? FileKind::unknown : found->second;
}

std::optional<Mesh> read_mesh_file(SceneBuilder& builder, const std::filesystem::path& path,
                                   const Place& place, const PlyColors& colors) {
  const FileKind kind = file_kind(path);
  if (kind != FileKind::obj && kind != FileKind::ply && kind != FileKind::stl) {
    builder.diagnostics.error(
        place, fmt::format("'{}' is no mesh: it ends in neither .obj, .ply nor .stl", path.string()));
    return std::nullopt;
  }
  try {
    const auto source = std::make_shared<const SourceText>(path.string(), builder.files.read(path));
    if (kind == FileKind::obj) return obj_as_one_mesh(builder, source);
    return plain_mesh(builder, source, [&](std::vector<std::string>& warnings) {
      return kind == FileKind::ply ? read_ply(source, warnings, colors) : read_stl(source, warnings);
    });
  } catch (const SceneError& error) {
    builder.diagnostics.error(place, error);
    return std::nullopt;
  }
}

}  // namespace umbral
