// What is worked out of a triangle once, for every hit that asks for it.
#include "scene/traced_mesh.h"

#include <gtest/gtest.h>

#include "support/stability.h"
#include "worlds.h"

namespace umbral {
namespace {

using namespace test;

using Long3 = glm::vec<3, long double>;

// The normals of needles, from 1e-30 to 1e15 long and up to a million times as long as wide, far off their axes: in float the
// edges' products cancel to nothing, or to rounding errors.
TEST(TracedMesh, KnowsTheNormalsOfNeedles) {
  Random random(1);
  double worst = 0;
  for (int i = 0; i < 100'000; ++i) {
    const double length = std::pow(10, random.between(-30, 15)),
                 width = length * std::pow(10, random.between(-6, 0));
    const Vec3 a(length * random.direction()), b(Vec3d(a) + length * random.direction());
    const Vec3 c(Vec3d(a) + 2.0 * (Vec3d(b) - Vec3d(a)) + width * random.direction());
    const Long3 n = cross(Long3(b) - Long3(a), Long3(c) - Long3(a));
    const long double size = glm::length(n);
    if (!(size > 0)) continue;
    Mesh mesh;
    mesh.positions = {a, b, c};
    mesh.triangles = {{0, 1, 2}};
    const Vec3 found = TracedMesh(mesh).triangles[0].n;
    worst = std::max(worst, static_cast<double>(glm::length(Long3(found) - n / size)));
  }
  EXPECT_LT(worst, 2e-7);
  record({"Rays that start on a surface", "error of the normals of needles, up to 10⁶ times as long as wide",
          "2e-7", fmt::format("{:.1e}", worst), ""});
}

TEST(TracedMesh, GivesATriangleWithoutAreaANormalAllTheSame) {
  Mesh mesh;
  mesh.positions = {{0, 0, 0}, {1, 1, 1}, {2, 2, 2}};
  mesh.triangles = {{0, 1, 2}};
  const Triangle triangle = TracedMesh(mesh).triangles[0];
  EXPECT_EQ(triangle.n, (Vec3{0, 0, 1}));
  EXPECT_EQ(triangle.sliver, 0);
}

}  // namespace
}  // namespace umbral
