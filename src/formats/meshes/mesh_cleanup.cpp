// Finding and mending what is degenerate in a mesh.
#include "formats/meshes/mesh_cleanup.h"

#include <fmt/format.h>

namespace umbral {
namespace {

Vec3d area_vector(const Mesh& mesh, const glm::uvec3& t) {
  const Vec3d a(mesh.positions[t.x]);
  return cross(Vec3d(mesh.positions[t.y]) - a, Vec3d(mesh.positions[t.z]) - a);
}

std::size_t drop_degenerate_triangles(Mesh& mesh) {
  return std::erase_if(mesh.triangles, [&](const glm::uvec3& t) {
    const Vec3d area = area_vector(mesh, t);
    return !(dot(area, area) > 0);  // of floats, the square cannot vanish in double
  });
}

// Unit length; none for a vector without direction.
std::optional<Vec3> unit(const Vec3& v) {
  const double length = glm::length(Vec3d(v));
  if (!(length > 0) || !std::isfinite(length)) return std::nullopt;
  return Vec3(Vec3d(v) / length);
}

std::size_t mend_normals(Mesh& mesh) {
  std::vector<bool> bad(mesh.normals.size(), false);
  std::size_t count = 0;
  for (std::size_t i = 0; i < mesh.normals.size(); ++i) {
    const std::optional<Vec3> normal = unit(mesh.normals[i]);
    bad[i] = !normal;
    count += bad[i] ? 1 : 0;
    mesh.normals[i] = normal.value_or(Vec3{0, 0, 1});
  }
  if (count == 0) return 0;
  std::vector<Vec3d> sums(mesh.normals.size(), Vec3d(0));
  for (const glm::uvec3& t : mesh.triangles)
    for (int k = 0; k < 3; ++k)
      if (bad[t[k]]) sums[t[k]] += area_vector(mesh, t);
  for (std::size_t i = 0; i < sums.size(); ++i)
    if (bad[i] && glm::length(sums[i]) > 0) mesh.normals[i] = Vec3(glm::normalize(sums[i]));
  return count;
}

std::size_t mend_uvs(std::vector<Vec2>& uvs) {
  std::size_t count = 0;
  for (Vec2& uv : uvs) {
    if (is_finite(uv)) continue;
    uv = {0, 0};
    ++count;
  }
  return count;
}

std::size_t mend_colors(std::vector<Spectrum>& colors) {
  std::size_t count = 0;
  for (Spectrum& color : colors) {
    Spectrum kept = color;
    for (int i = 0; i < 4; ++i) kept[i] = color[i] > 0 ? std::min(color[i], 1.0f) : 0.0f;  // not a number: 0
    count += kept != color ? 1 : 0;
    color = kept;
  }
  return count;
}

std::string counted(std::size_t count, const char* noun) {
  return fmt::format("{} {}{}", count, noun, count == 1 ? "" : "s");
}

}  // namespace

std::string MeshRepairs::text() const {
  std::string text;
  const auto add = [&](const std::string& part) { text += (text.empty() ? "" : "; ") + part; };
  if (triangles > 0) add("dropped " + counted(triangles, "triangle") + " without area");
  if (normals > 0) add("replaced " + counted(normals, "normal") + " without direction");
  if (uvs > 0) add("set " + counted(uvs, "texture coordinate") + " to 0 that were not finite");
  if (colors > 0) add("cut " + counted(colors, "vertex colour") + " to 0 … 1");
  return text;
}

MeshRepairs clean(Mesh& mesh) {
  MeshRepairs repairs;
  repairs.triangles = drop_degenerate_triangles(mesh);
  repairs.normals = mend_normals(mesh);
  repairs.uvs = mend_uvs(mesh.uvs) + mend_uvs(mesh.uvs1);
  repairs.colors = mend_colors(mesh.colors);
  return repairs;
}

bool has_finite_positions(const Mesh& mesh) {
  return std::all_of(mesh.positions.begin(), mesh.positions.end(),
                     [](const Vec3& p) { return is_finite(p); });
}

}  // namespace umbral
