// Tessellation of bilinear patches.
#include "formats/meshes/bilinear_patch.h"

namespace umbral {
namespace {

template <class T>
T blend(const std::array<T, 4>& c, float u, float v) {
  return (1 - v) * ((1 - u) * c[0] + u * c[1]) + v * ((1 - u) * c[2] + u * c[3]);
}

Vec3 normal_of(const BilinearPatch& patch, float u, float v) {
  if (patch.has_normals) return blend(patch.normals, u, v);
  const auto& p = patch.corners;
  const Vec3d du = (1.0 - v) * Vec3d(p[1] - p[0]) + double{v} * Vec3d(p[3] - p[2]);
  const Vec3d dv = (1.0 - u) * Vec3d(p[2] - p[0]) + double{u} * Vec3d(p[3] - p[1]);
  const Vec3d normal = cross(du, dv);
  return glm::length(normal) > 0 ? Vec3(glm::normalize(normal)) : Vec3(0);
}

}  // namespace

bool BilinearPatch::is_parallelogram() const {
  const Vec3d off = Vec3d(corners[0]) - Vec3d(corners[1]) - Vec3d(corners[2]) + Vec3d(corners[3]);
  const double size =
      glm::length(Vec3d(corners[3]) - Vec3d(corners[0])) + glm::length(Vec3d(corners[2]) - Vec3d(corners[1]));
  return glm::length(off) <= 1e-6 * size;
}

void append_patch(Mesh& mesh, const BilinearPatch& patch, int steps, bool with_normals) {
  const int n = patch.is_parallelogram() ? 1 : steps;
  const auto first = static_cast<std::uint32_t>(mesh.positions.size());
  for (int j = 0; j <= n; ++j)
    for (int i = 0; i <= n; ++i) {
      const float u = static_cast<float>(i) / static_cast<float>(n),
                  v = static_cast<float>(j) / static_cast<float>(n);
      mesh.positions.push_back(blend(patch.corners, u, v));
      mesh.uvs.push_back(blend(patch.uvs, u, v));
      if (with_normals) mesh.normals.push_back(normal_of(patch, u, v));
    }
  const auto at = [&](int i, int j) { return first + static_cast<std::uint32_t>(j * (n + 1) + i); };
  for (int j = 0; j < n; ++j)
    for (int i = 0; i < n; ++i) {
      mesh.triangles.push_back({at(i, j), at(i + 1, j), at(i + 1, j + 1)});
      mesh.triangles.push_back({at(i, j), at(i + 1, j + 1), at(i, j + 1)});
    }
}

}  // namespace umbral
