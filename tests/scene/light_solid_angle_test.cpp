// Lights sampled by solid angle: what the shapes subtend, uniform directions, and hard places.
#include <gtest/gtest.h>

#include "core/warp.h"
#include "support/stability.h"
#include "worlds.h"

namespace umbral {
namespace {

using namespace test;

constexpr LightId light{0};

// tan(Ω/2) = |a·(b×c)| / (1 + a·b + b·c + c·a) for unit vectors to the corners [van Oosterom and Strackee 1983].
double triangle_solid_angle(const Vec3d& p, Vec3d a, Vec3d b, Vec3d c) {
  a = glm::normalize(a - p);
  b = glm::normalize(b - p);
  c = glm::normalize(c - p);
  return 2 * std::atan2(std::abs(dot(a, cross(b, c))), 1 + dot(a, b) + dot(b, c) + dot(c, a));
}

TEST(SphericalRectangle, SubtendsWhatItsTrianglesDo) {
  Random random(1);
  for (int i = 0; i < 2000; ++i) {
    const Vec3d x = random.direction(), y = glm::normalize(cross(x, random.direction()));
    const glm::dvec2 length(random.log_between(0.01, 100), random.log_between(0.01, 100));
    const Vec3d corner = random.in_cube(1), p = random.in_cube(10);
    const Vec3d b = corner + x * length.x, c = b + y * length.y, d = corner + y * length.y;
    const double expected = triangle_solid_angle(p, corner, b, c) + triangle_solid_angle(p, corner, c, d);
    EXPECT_NEAR(SphericalRectangle(p, corner, x, y, length).solid_angle(), expected, 1e-9 + 1e-9 * expected);
  }
}

TEST(SphericalTriangle, SubtendsItsSolidAngle) {
  Random random(2);
  for (int i = 0; i < 2000; ++i) {
    const Vec3d a = random.in_cube(1), b = random.in_cube(1), c = random.in_cube(1), p = random.in_cube(1);
    EXPECT_NEAR(SphericalTriangle(p, a, b, c).solid_angle(), triangle_solid_angle(p, a, b, c), 1e-9);
  }
}

// Equal shares of the square must fall on equal solid angles: the part of u.x below ¼, ½ and ¾ cut off, told by the
// moments of the directions against those of points drawn by area and weighed.
struct Moments {
  Vec3d first{0};
  double second = 0, sum = 0;
  void add(const Vec3d& w, double weight) {
    first += weight * w;
    second += weight * sqr(w.x - w.y);
    sum += weight;
  }
};

void expect_same(const Moments& a, const Moments& b) {
  for (int i = 0; i < 3; ++i) EXPECT_NEAR(a.first[i] / a.sum, b.first[i] / b.sum, 2e-3);
  EXPECT_NEAR(a.second / a.sum, b.second / b.sum, 2e-3);
}

constexpr int grid = 200;
Vec2 grid_point(int i) {
  return {(static_cast<float>(i % grid) + 0.5f) / grid, (static_cast<float>(i / grid) + 0.5f) / grid};
}

TEST(SphericalRectangle, IsSampledEvenly) {
  Random random(3);
  for (int k = 0; k < 20; ++k) {
    const Vec3d x = random.direction(), y = glm::normalize(cross(x, random.direction())), z = cross(x, y);
    const Vec3d corner = random.in_cube(1),
                p = corner + 0.3 * random.in_cube(1) + (k % 2 == 0 ? 0.5 : -0.5) * z;
    const glm::dvec2 length(random.between(0.5, 2), random.between(0.5, 2));
    const SphericalRectangle seen(p, corner, x, y, length);
    Moments by_angle, by_area;
    for (int i = 0; i < grid * grid; ++i) {
      const glm::dvec2 at = seen.sample(grid_point(i));
      ASSERT_TRUE(at.x >= 0 && at.x <= 1 && at.y >= 0 && at.y <= 1);
      by_angle.add(glm::normalize(corner + at.x * length.x * x + at.y * length.y * y - p), 1);
      const glm::dvec2 u(grid_point(i));
      const Vec3d way = corner + u.x * length.x * x + u.y * length.y * y - p;
      const double distance = glm::length(way);
      by_area.add(way / distance, std::abs(dot(way, z)) / (distance * distance * distance));
    }
    expect_same(by_angle, by_area);
  }
}

TEST(SphericalTriangle, IsSampledEvenly) {
  Random random(4);
  for (int k = 0; k < 20; ++k) {
    const Vec3d a = random.in_cube(1), b = random.in_cube(1), c = random.in_cube(1);
    const Vec3d n = glm::normalize(cross(b - a, c - a));
    const Vec3d p = (a + b + c) / 3.0 + 0.3 * random.in_cube(1) + (k % 2 == 0 ? 0.5 : -0.5) * n;
    const SphericalTriangle seen(p, a, b, c);
    Moments by_angle, by_area;
    for (int i = 0; i < grid * grid; ++i) {
      const Vec3d w = seen.sample(grid_point(i));
      ASSERT_NEAR(glm::length(w), 1, 1e-9);
      by_angle.add(w, 1);
      const Vec2 weights = square_to_triangle(grid_point(i));
      const Vec3d way =
          a + static_cast<double>(weights.x) * (b - a) + static_cast<double>(weights.y) * (c - a) - p;
      const double distance = glm::length(way);
      by_area.add(way / distance, std::abs(dot(way, n)) / (distance * distance * distance));
    }
    expect_same(by_angle, by_area);
  }
}

// From afar, down to 1e-12 sr, and from close by: every sample is on the sphere's near side, within the cone, and
// the density is one over the cone's solid angle.
TEST(SphereCone, KeepsItsDigits) {
  Random random(5);
  for (const double distance : {1.00001, 1.5, 10.0, 1e3, 1e5, 1.8e6}) {
    const Vec3d p = distance * random.direction();
    const SphereCone cone(p);
    const double half =
        std::sqrt((1 - std::sqrt(1 - 1 / sqr(distance))) / 2);  // sin of half of the half angle
    const double expected =
        distance > 100 ? pi_d / sqr(distance) * (1 + 0.25 / sqr(distance)) : 4 * pi_d * sqr(half);
    EXPECT_NEAR(1 / cone.pdf() / expected, 1, 1e-6) << distance;
    double mean = 0;
    for (int i = 0; i < grid * grid; ++i) {
      const Vec3d q = cone.sample(grid_point(i));
      ASSERT_NEAR(glm::length(q), 1, 1e-12);
      ASSERT_GE(dot(q, p), 1 - 1e-9) << "not on the near side";
      // sin²θ/sin²θₘ = d² sin²θ is uniform, but for the curvature of the cone.
      mean += dot(cross(q - p, p), cross(q - p, p)) / dot(q - p, q - p) / (grid * grid);
    }
    if (distance > 100) {
      EXPECT_NEAR(mean, 0.5, 1e-3) << distance;
    }
  }
}

// What a light subtends is the mean of 1/pdf where every sample arrives. Gives its relative error; 0 where there is nothing
// to see.
double expect_subtends(const Scene& scene, const Vec3& p, double solid_angle) {
  double sum = 0;
  for (int i = 0; i < grid * grid; ++i) {
    const auto sample = scene.sample_light(light, LightReceiver{p, {0, 0, 1}}, grid_point(i));
    if (!sample) continue;
    EXPECT_TRUE(is_finite(sample->wi) && std::isfinite(sample->pdf) && sample->pdf > 0);
    EXPECT_NEAR(glm::length(sample->wi), 1, 1e-5);
    sum += 1 / static_cast<double>(sample->pdf) / (grid * grid);
  }
  EXPECT_NEAR(sum, solid_angle, 5e-3 * solid_angle + 1e-9 * std::min(solid_angle, 1.0))
      << p.x << " " << p.y << " " << p.z;
  return solid_angle > 0 ? std::abs(sum / solid_angle - 1) : 0;
}

void record_solid_angle(const std::string& of, double worst) {
  record({"Lights", "the solid angle of " + of + " is another, or no number", "≤ 0.5 %",
          fmt::format("{:.2g} %", 100 * worst), "pbrt-v4 #134, #211; openmoonray #251; mitsuba3 PR #1733"});
}

double square_solid_angle(const Vec3d& p) {
  const Vec3d a(-1, -1, 0), b(1, -1, 0), c(1, 1, 0), d(-1, 1, 0);
  return triangle_solid_angle(p, a, b, c) + triangle_solid_angle(p, a, c, d);
}

// Inside a sphere and on the plane of a rectangle the samples by area take over.
TEST(AreaLight, InHardPlacesGivesFiniteSamplesAndNoLightFromItsBack) {
  SceneDescription ball = world_of(sphere({0, 0, 0}, 2), {}, false, grey(1));
  ball.shapes[0].two_sided = true;
  const Scene inside_of(std::move(ball));
  double inside = 0;
  for (const float x : {0.0f, 0.5f, 1.5f})
    inside = std::max(inside, expect_subtends(inside_of, {x, 0, 0}, 4 * pi_d));
  record_solid_angle("a sphere that holds the point", inside);
  record_solid_angle("a sphere, down to 3e-12 sr",
                     std::max(expect_subtends(inside_of, {2e6f, 0, 0}, pi_d * 1e-12),
                              expect_subtends(inside_of, {4, 0, 0}, 2 * pi_d * (1 - std::sqrt(0.75)))));

  const Scene panel(world_of(rectangle({-1, -1, 0}, {2, 0, 0}, {0, 2, 0}), {}, false, grey(1)));
  for (const float z : {0.0f, -0.1f, -5.0f}) expect_subtends(panel, {0.3f, 0.2f, z}, 0);
  expect_subtends(panel, {3, 0, 0}, 0);
  double worst = expect_subtends(panel, {0, 0, 2e6f}, 1e-12);
  for (const float z : {0.01f, 0.3f, 1.0f, 1.9f, 2.1f, 50.0f})
    worst = std::max(worst, expect_subtends(panel, {0.3f, 0.2f, z}, square_solid_angle({0.3f, 0.2f, z})));
  record_solid_angle("a rectangle, from next to it down to 1e-12 sr", worst);
}

// A square cut into two halves, strips of a millionth and faces without area, in any order.
TEST(AreaLight, WithNeedlesAndFacesWithoutAreaKeepsItsFlux) {
  Mesh mesh;
  const float cuts[] = {-1, -1 + 1e-6f, -1 + 2e-6f, 0.1f, 0.1f, 1};
  for (const float x : cuts) {
    mesh.positions.push_back({x, -1, 0});
    mesh.positions.push_back({x, 1, 0});
  }
  for (unsigned i = 0; i + 2 < mesh.positions.size(); i += 2) {
    mesh.triangles.push_back({i, i + 2, i + 1});
    mesh.triangles.push_back({i, i, i + 1});
    mesh.triangles.push_back({i + 1, i + 2, i + 3});
  }
  const Scene scene(world_of(mesh, {}, false, grey(1)));
  double worst = expect_subtends(scene, {0, 0, 2e6f}, 1e-12);
  for (const float z : {0.1f, 0.5f, 1.8f, 30.0f})
    worst = std::max(worst, expect_subtends(scene, {0.3f, 0.2f, z}, square_solid_angle({0.3f, 0.2f, z})));
  record_solid_angle("a mesh with needles of 1 : 2e6 and faces without area, down to 1e-12 sr", worst);
  expect_subtends(scene, {0.3f, 0.2f, -1}, 0);
  expect_subtends(scene, {-1, 0.2f, 0}, 0);
}

// A mesh all around: its triangles are chosen by the tree and sampled by solid angle, and must give 4π.
TEST(AreaLight, AllAroundSubtendsTheWholeSphere) {
  for (const int levels : {0, 2}) {
    Mesh mesh = icosphere(levels);
    SceneDescription description = world_of(mesh, {}, false, grey(1));
    description.shapes[0].two_sided = true;
    const Scene scene(std::move(description));
    Random random(7);
    for (const Vec3& p : {Vec3(0, 0, 0), Vec3(0.3f, 0.4f, 0.1f), Vec3(0.7f, 0, 0)}) {
      double sum = 0;
      constexpr int n = 60'000;
      for (int i = 0; i < n; ++i) {
        const auto sample = scene.sample_light(light, LightReceiver{p, {0, 0, 1}}, random.square());
        ASSERT_TRUE(sample);
        const Ray ray{p, sample->wi};
        const auto hit = scene.intersect(ray);
        ASSERT_TRUE(hit);
        sum += 1 / static_cast<double>(sample->pdf) / n;
        if (i % 50 != 0) continue;
        const double pdf =
            scene.light_pdf(LightSelection::tree, {p, {0, 0, 1}}, scene.surface(ray, *hit), *hit, ray.d);
        EXPECT_NEAR(pdf / static_cast<double>(sample->pdf), 1, 5e-3) << "on an edge?";
      }
      EXPECT_NEAR(sum / (4 * pi_d), 1, 0.02);
    }
  }
}

}  // namespace
}  // namespace umbral
