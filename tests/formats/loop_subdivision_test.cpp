// Loop's scheme: what it leaves as it is, what it converges to, and what it refuses.
#include "formats/meshes/loop_subdivision.h"

#include <stdexcept>

#include <gtest/gtest.h>

namespace umbral {
namespace {

// n × n squares of two triangles in the plane z = 0.
Mesh flat_grid(int n) {
  Mesh mesh;
  for (int j = 0; j <= n; ++j)
    for (int i = 0; i <= n; ++i) mesh.positions.push_back({i, j, 0});
  const auto at = [&](int i, int j) { return static_cast<std::uint32_t>(j * (n + 1) + i); };
  for (int j = 0; j < n; ++j)
    for (int i = 0; i < n; ++i) {
      mesh.triangles.push_back({at(i, j), at(i + 1, j), at(i + 1, j + 1)});
      mesh.triangles.push_back({at(i, j), at(i + 1, j + 1), at(i, j + 1)});
    }
  return mesh;
}

Mesh octahedron() {
  Mesh mesh;
  mesh.positions = {{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}};
  mesh.triangles = {{0, 2, 4}, {2, 1, 4}, {1, 3, 4}, {3, 0, 4}, {2, 0, 5}, {1, 2, 5}, {3, 1, 5}, {0, 3, 5}};
  return mesh;
}

TEST(LoopSubdivision, KeepsAPlaneAndItsStraightSides) {
  const Mesh fine = loop_subdivided(flat_grid(3), 2);
  EXPECT_EQ(fine.triangles.size(), 18u * 16);
  for (std::size_t i = 0; i < fine.positions.size(); ++i) {
    EXPECT_EQ(fine.positions[i].z, 0);
    EXPECT_GE(std::min(fine.positions[i].x, fine.positions[i].y), -1e-6f);
    EXPECT_LE(std::max(fine.positions[i].x, fine.positions[i].y), 3 + 1e-6f);
    EXPECT_LT(glm::length(fine.normals[i] - Vec3(0, 0, 1)), 1e-5f) << i;
  }
}

// The centre of a regular inner vertex stays where its neighbours are even around it.
TEST(LoopSubdivision, ReachesItsLimitAtAnyLevel) {
  const Mesh coarse = loop_subdivided(octahedron(), 1), fine = loop_subdivided(octahedron(), 4);
  EXPECT_EQ(fine.triangles.size(), 8u * 256);
  // The control vertices come first at every level, and all are on the limit surface.
  for (std::size_t i = 0; i < 18; ++i)
    EXPECT_LT(glm::length(coarse.positions[i] - fine.positions[i]), 1e-6f) << i;
  // By the mask of valence 4: β = 3/32, and the limit weight of a neighbour is 1/(4 + 3/(8β)) = 1/8.
  EXPECT_NEAR(fine.positions[0].x, 0.5, 1e-6);
}

TEST(LoopSubdivision, NormalsAreThoseOfTheSurface) {
  const Mesh fine = loop_subdivided(octahedron(), 4);
  std::vector<Vec3d> sums(fine.positions.size(), Vec3d(0));
  for (const glm::uvec3& t : fine.triangles) {
    const Vec3d a(fine.positions[t.x]), b(fine.positions[t.y]), c(fine.positions[t.z]);
    for (int k = 0; k < 3; ++k) sums[t[k]] += cross(b - a, c - a);
  }
  for (std::size_t i = 0; i < sums.size(); ++i)
    EXPECT_GT(dot(glm::normalize(sums[i]), Vec3d(fine.normals[i])), 0.998) << i;
}

TEST(LoopSubdivision, RefusesWhatIsNoSurface) {
  Mesh fan = flat_grid(1);
  fan.positions.push_back({0, 0, 1});
  fan.triangles.push_back({0, 3, 4});
  EXPECT_THROW(loop_subdivided(fan, 1), std::invalid_argument) << "three triangles at one edge";
  Mesh wound = flat_grid(1);
  std::swap(wound.triangles[1].y, wound.triangles[1].z);
  EXPECT_THROW(loop_subdivided(wound, 1), std::invalid_argument);
  Mesh twice = flat_grid(1);
  twice.triangles[0].y = twice.triangles[0].x;
  EXPECT_THROW(loop_subdivided(twice, 1), std::invalid_argument);
  EXPECT_THROW(loop_subdivided(flat_grid(1), 13), std::invalid_argument);
  EXPECT_EQ(loop_subdivided(flat_grid(1), 0).triangles.size(), 2u);
}

}  // namespace
}  // namespace umbral
