// Triangulation, repair and topology of meshes.
#include <random>

#include <gtest/gtest.h>

#include "formats/meshes/mesh_cleanup.h"
#include "formats/meshes/mesh_topology.h"
#include "formats/meshes/triangulate.h"

namespace umbral {
namespace {

Mesh triangulated(const std::vector<Vec3>& polygon) {
  Mesh mesh;
  mesh.positions = polygon;
  std::vector<std::uint32_t> corners;
  for (std::uint32_t i = 0; i < polygon.size(); ++i) corners.push_back(i);
  EXPECT_TRUE(triangulate(corners, mesh.positions, mesh.triangles));
  return mesh;
}

// A polygon around the origin whose radius varies at random, so that it is concave but does not cross itself.
struct Star {
  std::vector<Vec3> corners;
  double area = 0;
};

Star random_star(std::mt19937& random, int corners, const Frame& frame) {
  std::uniform_real_distribution<float> radius(0.2f, 1);
  std::vector<Vec2> flat;
  for (int i = 0; i < corners; ++i) {
    const float angle = two_pi * static_cast<float>(i) / static_cast<float>(corners);
    flat.push_back(radius(random) * Vec2(std::cos(angle), std::sin(angle)));
  }
  Star star;
  for (std::size_t i = 0; i < flat.size(); ++i) {
    const glm::dvec2 a(flat[i]), b(flat[(i + 1) % flat.size()]);
    star.area += (a.x * b.y - a.y * b.x) / 2;
    star.corners.push_back(frame.to_world({flat[i].x, flat[i].y, 3}));
  }
  return star;
}

TEST(Triangulate, ConcavePolygonsInAnyPlaneKeepAreaAndSide) {
  std::mt19937 random(1);
  for (int trial = 0; trial < 200; ++trial) {
    const Vec3 normal = glm::normalize(Vec3(std::normal_distribution<float>()(random),
                                            std::normal_distribution<float>()(random),
                                            std::normal_distribution<float>()(random)));
    const int corners = 4 + trial % 30;
    const Star star = random_star(random, corners, frame_from_normal(normal));
    const Mesh mesh = triangulated(star.corners);
    ASSERT_EQ(mesh.triangles.size(), static_cast<std::size_t>(corners - 2));
    double area = 0;
    for (const glm::uvec3& t : mesh.triangles) {
      const Vec3d a(mesh.positions[t.x]), b(mesh.positions[t.y]), c(mesh.positions[t.z]);
      const double signed_area = dot(cross(b - a, c - a), Vec3d(normal)) / 2;
      EXPECT_GT(signed_area, -1e-6) << "trial " << trial;
      area += signed_area;
    }
    EXPECT_NEAR(area, star.area, 1e-5) << "trial " << trial;
  }
}

TEST(Triangulate, DegeneratePolygonsEnd) {
  EXPECT_EQ(triangulated({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {3, 0, 0}}).triangles.size(), 2u);
  EXPECT_EQ(triangulated({{0, 0, 0}, {0, 0, 0}, {0, 0, 0}, {0, 0, 0}, {0, 0, 0}}).triangles.size(), 3u);
  EXPECT_EQ(triangulated({{0, 0, 0}, {1, 1, 0}, {1, 0, 0}, {0, 1, 0}}).triangles.size(), 2u)
      << "crosses itself";
}

TEST(Triangulate, HugeConcavePolygonsAreRefused) {
  std::mt19937 random(1);
  const Star star = random_star(random, static_cast<int>(largest_concave_polygon) + 1, Frame{});
  std::vector<std::uint32_t> corners(star.corners.size());
  for (std::uint32_t i = 0; i < corners.size(); ++i) corners[i] = i;
  std::vector<glm::uvec3> triangles;
  EXPECT_FALSE(triangulate(corners, star.corners, triangles));
  EXPECT_TRUE(triangles.empty());
}

TEST(MeshCleanup, DropsTrianglesWithoutArea) {
  Mesh mesh;
  mesh.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {2, 0, 0}, {1, 0, 0}};
  mesh.triangles = {{0, 1, 2}, {0, 0, 1}, {0, 1, 3}, {0, 1, 4}, {2, 1, 0}};
  const MeshRepairs repairs = clean(mesh);
  EXPECT_EQ(repairs.triangles, 3u);
  EXPECT_EQ(mesh.triangles, (std::vector<glm::uvec3>{{0, 1, 2}, {2, 1, 0}}));
  EXPECT_EQ(repairs.text(), "dropped 3 triangles without area");
}

TEST(MeshCleanup, TinyTrianglesStay) {
  Mesh mesh;
  mesh.positions = {{0, 0, 0}, {1e-38f, 0, 0}, {0, 1e-38f, 0}};
  mesh.triangles = {{0, 1, 2}};
  EXPECT_EQ(clean(mesh).triangles, 0u);
  EXPECT_EQ(mesh.triangles.size(), 1u);
}

TEST(MeshCleanup, MendsNormalsAndUvs) {
  Mesh mesh;
  mesh.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {9, 9, 9}};
  mesh.triangles = {{0, 1, 2}};
  mesh.normals = {{0, 0, 0}, {3, 0, 4}, {std::nanf(""), 0, 1}, {0, infinity, 0}};
  mesh.uvs = {{0, 0}, {1, infinity}, {std::nanf(""), 1}, {1, 1}};
  const MeshRepairs repairs = clean(mesh);
  EXPECT_EQ(repairs.normals, 3u);
  EXPECT_EQ(repairs.uvs, 2u);
  EXPECT_EQ(mesh.normals, (std::vector<Vec3>{{0, 0, 1}, {0.6f, 0, 0.8f}, {0, 0, 1}, {0, 0, 1}}));
  EXPECT_EQ(mesh.uvs, (std::vector<Vec2>{{0, 0}, {0, 0}, {0, 0}, {1, 1}}));
  EXPECT_EQ(repairs.text(),
            "replaced 3 normals without direction; set 2 texture coordinates to 0 that were not finite");
}

Mesh octahedron() {
  Mesh mesh;
  mesh.positions = {{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}};
  mesh.triangles = {{0, 2, 4}, {2, 1, 4}, {1, 3, 4}, {3, 0, 4}, {2, 0, 5}, {1, 2, 5}, {3, 1, 5}, {0, 3, 5}};
  return mesh;
}

TEST(MeshTopology, ClosedIsEveryEdgeTwice) {
  Mesh mesh = octahedron();
  EXPECT_TRUE(is_closed(mesh));
  const glm::uvec3 taken = mesh.triangles.back();
  mesh.triangles.pop_back();
  EXPECT_FALSE(is_closed(mesh));
  for (int k = 0; k < 3; ++k) mesh.positions.push_back(mesh.positions[taken[k]]);
  mesh.triangles.push_back({6, 7, 8});  // the same corners by other numbers
  EXPECT_TRUE(is_closed(mesh));
  mesh.triangles.push_back({6, 7, 8});
  EXPECT_FALSE(is_closed(mesh));
  EXPECT_FALSE(is_closed(Mesh{}));
}

TEST(MeshTopology, EnclosesWhatIsInside) {
  const Mesh mesh = octahedron();
  std::mt19937 random(1);
  std::uniform_real_distribution<double> coordinate(-1, 1);
  int inside = 0;
  for (int i = 0; i < 1000; ++i) {
    const Vec3d p(coordinate(random), coordinate(random), coordinate(random));
    const bool expected = std::abs(p.x) + std::abs(p.y) + std::abs(p.z) < 1;
    EXPECT_EQ(encloses(mesh, p), expected);
    inside += expected ? 1 : 0;
  }
  EXPECT_GT(inside, 100);
  Mesh open = octahedron();
  open.triangles.pop_back();
  EXPECT_FALSE(encloses(open, {0.1, 0.1, 0.1}));
}

}  // namespace
}  // namespace umbral
