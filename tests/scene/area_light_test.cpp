// Area lights: their irradiance in closed form, by their samples and by what rays meet; their densities and power.
#include "scene/lights/area.h"

#include <gtest/gtest.h>

#include "support/chi_square.h"
#include "support/oracles.h"
#include "support/quadrature.h"
#include "worlds.h"

namespace umbral {
namespace {

using namespace test;

constexpr LightId light{0};

// ∫ L cos⁺ dω at a point with normal n by the light's samples, at the midpoints of a grid over u; no shadows.
double irradiance(const Scene& scene, const Vec3& p, const Vec3& n, int grid) {
  double sum = 0;
  for (int i = 0; i < grid * grid; ++i) {
    const Vec2 u{(static_cast<float>(i % grid) + 0.5f) / static_cast<float>(grid),
                 (static_cast<float>(i / grid) + 0.5f) / static_cast<float>(grid)};
    const auto sample = scene.sample_light(light, p, u);
    if (sample) sum += std::max(0.0f, dot(sample->wi, n)) * sample->radiance.g / sample->pdf;
  }
  return sum / (grid * grid);
}

Scene shining(ShapeKinds kind, const Affine& place = {}, bool instanced = false) {
  return Scene(world_of(std::move(kind), place, instanced, grey(2)));
}

// Parallel rectangles seen from a corner of one: the known factor of a point is Lambert's, that of the areas its mean.
TEST(Irradiance, OfARectangleIsThatOfItsPolygon) {
  Random random(1);
  for (int i = 0; i < 20; ++i) {
    const Vec3 origin(random.in_cube(1)), u(random.in_cube(1)), v(random.in_cube(1));
    const Scene scene = shining(rectangle(origin, u, v));
    const Vec3d facing = glm::normalize(cross(Vec3d(u), Vec3d(v)));
    const Vec3d middle = Vec3d(origin) + (Vec3d(u) + Vec3d(v)) / 2.0;
    const Vec3d p = middle + random.between(1.5, 4) * glm::normalize(facing + 0.5 * random.direction());
    const Vec3d n = glm::normalize(glm::normalize(middle - p) + 0.7 * random.direction());
    const std::vector<Vec3d> corners{Vec3d(origin), Vec3d(origin + u), Vec3d(origin + u + v),
                                     Vec3d(origin + v)};
    const double expected = 2 * pi_d * polygon_form_factor(p, n, corners);
    EXPECT_NEAR(irradiance(scene, Vec3(p), Vec3(n), 256), expected, 3e-4 * expected + 1e-6);
  }
}

// The form factors of unit squares in a cube [Howell 2010, C-11 and C-14]: the mean over the receiver.
TEST(Irradiance, OfSquaresInACubeGivesTheKnownFormFactors) {
  const Scene scene = shining(rectangle({0, 0, 0}, {1, 0, 0}, {0, 1, 0}));
  double opposite = 0, beside = 0;
  constexpr int n = 24;
  for (int i = 0; i < n; ++i)
    for (int k = 0; k < n; ++k) {
      const float a = (static_cast<float>(i) + 0.5f) / n, b = (static_cast<float>(k) + 0.5f) / n;
      opposite += irradiance(scene, {a, b, 1}, {0, 0, -1}, 48) / (2 * pi_d);
      beside += irradiance(scene, {0, a, b}, {1, 0, 0}, 48) / (2 * pi_d);
    }
  EXPECT_NEAR(opposite / (n * n), 0.199825, 1e-4);
  EXPECT_NEAR(beside / (n * n), 0.200044, 3e-3) << "the nearest points meet the light at its edge";
}

TEST(Irradiance, OfADiskIsKnown) {
  const Scene scene = shining(disk({0, 0, 0}, {0, 0, 1}, 1.5f));
  for (const double height : {0.5, 1.0, 3.0, 20.0})
    for (const double offset : {0.0, 0.4, 1.5, 3.0}) {
      const double expected = 2 * pi_d * disk_form_factor(height, offset, 1.5);
      const Vec3 p(Vec3d(offset, 0, height));
      EXPECT_NEAR(irradiance(scene, p, {0, 0, -1}, 256), expected, 5e-4 * expected)
          << height << ", " << offset;
    }
}

TEST(Irradiance, OfASphereIsKnownAlsoWhereTheHorizonCutsIt) {
  const Scene scene = shining(sphere({0, 0, 0}, 0.75f));
  for (const double distance : {1.5, 3.0, 20.0})
    for (const double degrees : {0.0, 30.0, 60.0, 80.0, 90.0, 100.0, 110.0, 160.0}) {
      const double beta = glm::radians(degrees);
      const Vec3d p(0, 0, distance), n(std::sin(beta), 0, -std::cos(beta));
      const double expected = 2 * pi_d * sphere_form_factor(p, n, {0, 0, 0}, 0.75);
      EXPECT_NEAR(irradiance(scene, Vec3(p), Vec3(n), 512), expected, 1e-3 * expected + 2e-5 / sqr(distance))
          << distance << ", " << degrees;
    }
}

TEST(Irradiance, OfTrianglesIsThatOfTheirPolygons) {
  const Mesh mesh = icosphere(1);
  const Scene scene = shining(mesh);
  const Vec3d p(2, 1, 2), n = glm::normalize(Vec3d(-1, -0.2, -1));
  double expected = 0;
  for (const glm::uvec3& t : mesh.triangles) {
    const Vec3d a(mesh.positions[t.x]), b(mesh.positions[t.y]), c(mesh.positions[t.z]);
    if (dot(cross(b - a, c - a), p - a) > 0) expected += 2 * pi_d * polygon_form_factor(p, n, {a, b, c});
  }
  // 80 triangles share the first number: each gets 16 columns of the grid.
  EXPECT_NEAR(irradiance(scene, Vec3(p), Vec3(n), 1280), expected, 3e-3 * expected);
}

// What a light tells by its samples, occlusion included, must be what rays find that are sent to it blindly.
struct LightCase {
  const char* name;
  ShapeKinds kind;
  double reach;  // of a sphere about the shape's origin that holds it
};

std::vector<LightCase> light_cases() {
  Mesh leaf = polygon({{-1, -1, 0}, {1, -1, 0}, {0.5f, 1, 0.5f}, {-1, 1, -0.2f}});
  leaf.uvs = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
  return {{"sphere", sphere({0, 0, 0}, 1), 1},
          {"disk", disk({0, 0, 0}, {0, 0, 1}, 1), 1},
          {"torus", torus(0.75f, 0.25f), 1},
          {"rectangle", rectangle({-1, -0.5f, 0}, {2, 0, 0}, {0, 1, 0}), 1.2},
          {"box", box({-0.5f, -0.5f, -0.5f}, {0.5f, 0.5f, 0.5f}), 0.9},
          {"mesh", leaf, 1.6}};
}

struct Looks {
  bool textured, two_sided;
  float alpha;
};

Scene lit_world(const LightCase& shape, const Affine& place, bool instanced, const Looks& looks) {
  SceneDescription description = world_of(shape.kind, place, instanced, grey(2));
  Shape& emitter = instanced ? description.objects[0].shapes[0] : description.shapes[0];
  if (looks.textured) {
    CheckerTexture halves;
    halves.even = grey(0.1f);
    halves.odd = grey(5);
    halves.uv_scale = {2, 1};
    emitter.emission.map = add_texture(description, halves);
  }
  emitter.two_sided = looks.two_sided;
  description.materials[0].alpha.value = looks.alpha;
  return Scene(std::move(description));
}

struct Estimate {
  double sum = 0, squares = 0;
  int n = 0;

  void add(double x) {
    sum += x;
    squares += x * x;
    ++n;
  }
  double mean() const { return sum / n; }
  double error() const { return std::sqrt(std::max(0.0, squares / n - sqr(mean())) / n); }
};

void expect_samples_find_what_rays_meet(const Looks& looks, std::uint64_t seed) {
  Random random(seed);
  for (const LightCase& shape : light_cases())
    for (int i = 0; i < 4; ++i) {
      const bool instanced = i % 2 == 1;
      SCOPED_TRACE(std::string(shape.name) + (instanced ? ", instanced " : " ") + std::to_string(i));
      const Affine place = random_affine(random, 0.4, 1.6, 2);
      const Scene scene = lit_world(shape, place, instanced, looks);
      // From the outer side (above, where the shape is flat), so that one-sided lights are seen.
      const Vec3d away = glm::normalize(Vec3d(0.4, 0.3, 1) + 0.5 * random.direction());
      const Vec3 p(place.point(3.0 * away));
      const Vec3d axis = place.offset - Vec3d(p);
      const double reach = 1.6 * shape.reach, distance = glm::length(axis);
      const double one_minus_cos = distance > reach * 1.01 ? 1 - std::sqrt(1 - sqr(reach / distance)) : 2;
      const Frame frame = frame_from_normal(Vec3(axis / distance));
      Estimate by_light, by_ray;
      for (int k = 0; k < 40'000; ++k) {
        const auto sample = scene.sample_light(light, p, random.square());
        const bool seen = sample && !scene.occluded({p, sample->target - p, 0, 1});
        by_light.add(seen ? sample->radiance.g / sample->pdf : 0);
      }
      for (int k = 0; k < 160'000; ++k) {
        const double h = random.between(0, one_minus_cos), phi = random.between(0, 2 * pi_d);
        const double r = std::sqrt(h * (2 - h));
        const Ray ray{p, frame.to_world(Vec3(Vec3d(r * std::cos(phi), r * std::sin(phi), 1 - h)))};
        const auto surface = seen(scene, ray);
        by_ray.add(surface ? scene.emitted(*surface, -ray.d).g * 2 * pi_d * one_minus_cos : 0);
      }
      EXPECT_NEAR(by_light.mean(), by_ray.mean(), 4.5 * std::hypot(by_light.error(), by_ray.error()));
      EXPECT_LT(by_ray.error(), 0.05 * by_ray.mean()) << "too little light to tell";
    }
}

TEST(AreaLight, SamplesFindWhatRaysMeet) { expect_samples_find_what_rays_meet({false, false, 1}, 2); }
TEST(AreaLight, SamplesFindWhatRaysMeetByATexture) {
  expect_samples_find_what_rays_meet({true, false, 1}, 3);
}
TEST(AreaLight, SamplesFindWhatRaysMeetOnBothSides) {
  expect_samples_find_what_rays_meet({true, true, 1}, 4);
}
TEST(AreaLight, SamplesFindWhatRaysMeetWhereItIsPartlyOpaque) {
  expect_samples_find_what_rays_meet({false, false, 0.4f}, 5);
}

// Two ways to the same density: drawn towards the light, or met by chance.
TEST(AreaLight, TellsTheDensityOfItsOwnSamples) {
  Random random(6);
  for (const LightCase& shape : light_cases())
    for (int i = 0; i < 6; ++i) {
      SCOPED_TRACE(shape.name);
      const Affine place = random_affine(random, 0.3, 3, 2);
      SceneDescription description = world_of(shape.kind, place, i % 2 == 1, grey(2));
      description.lights.emplace_back(PointLight{{0, 0, 100}, grey(30)});
      const Scene scene(std::move(description));
      const double choice = scene.choose_light(LightSelection::power, {}, 0).probability;
      ASSERT_EQ(scene.choose_light(LightSelection::power, {}, 0).light, light);
      EXPECT_TRUE(choice > 0.03 && choice < 0.97) << choice;
      int compared = 0;
      for (int k = 0; k < 1000; ++k) {
        const Vec3 p(place.point(2.5 * glm::normalize(Vec3d(0, 0, 1) + 0.7 * random.direction())));
        const auto sample = scene.sample_light(light, LightReceiver{p, {0, 0, 1}}, random.square());
        if (!sample) continue;
        const Ray ray{p, sample->wi};
        const auto hit = scene.intersect(ray);
        if (!hit || std::abs(hit->t - sample->distance) > 1e-4f * sample->distance) continue;
        const Surface surface = scene.surface(ray, *hit);
        ASSERT_EQ(surface.light, light);
        if (std::abs(dot(surface.ng, sample->wi)) < 0.02f)
          continue;  // the cosine itself has few digits there
        ++compared;
        const double pdf = scene.light_pdf(LightSelection::power, {p, {0, 0, 1}}, surface, *hit, sample->wi);
        EXPECT_NEAR(pdf / (choice * sample->pdf), 1, 2e-3);
      }
      EXPECT_GT(compared, 150);
    }
}

// Samples of a floor of triangles of many sizes fall on each by its area, where it is instanced.
TEST(AreaLight, ChoosesTrianglesOfAnInstanceByTheirArea) {
  Random random(7);
  Mesh floor;
  double x = 0;
  std::vector<double> expected;
  constexpr int draws = 200'000;
  for (int i = 0; i < 200; ++i) {
    const double width = random.log_between(1e-3, 1);
    const auto first = static_cast<unsigned>(floor.positions.size());
    for (const Vec3d& p : {Vec3d(x, 0, 0), Vec3d(x + width, 0, 0), Vec3d(x, 1, 0)})
      floor.positions.emplace_back(p);
    floor.triangles.push_back({first, first + 1, first + 2});
    expected.push_back(width);
    x += width;
  }
  for (double& share : expected) share *= draws / x;
  const Scene scene = shining(floor, {}, true);
  std::vector<double> observed(expected.size());
  const Vec3 p(Vec3d(x / 2, 0, x));
  for (int i = 0; i < draws; ++i) {
    const auto sample = scene.sample_light(light, p, random.square());
    ASSERT_TRUE(sample);
    const Vec3 q = p + sample->wi * sample->distance;
    // On the edge between two triangles either may be told.
    const auto hit = scene.intersect({q + Vec3(1e-6f, 1e-6f, 1), {0, 0, -1}});
    if (hit) ++observed[hit->primitive];
    EXPECT_NEAR(sample->pdf, 2 / x * sqr(sample->distance) / -sample->wi.z, 1e-4 * sample->pdf);
  }
  EXPECT_GT(chi_square(observed, expected).p, 1e-4);
}

// The mean of 1/density is the area: 2πa² + 2πac asin(e)/e for a prolate spheroid, 4π for the unit sphere.
TEST(AreaLight, KnowsItsAreaHoweverItIsStretched) {
  Random random(8);
  for (const double c : {1.0, 1.5, 4.0}) {
    const Affine place = random_similarity(random, 0.5, 3) * scaling({1, 1, c});
    SceneDescription description = world_of(sphere({0, 0, 0}, 1), place, true, grey(2));
    description.objects[0].shapes[0].two_sided = true;
    const Scene scene(std::move(description));
    const double e = std::sqrt(1 - 1 / (c * c));
    const double area = 0.25 * 2 * pi_d * (1 + (e > 0 ? c * std::asin(e) / e : 1));
    double sum = 0;
    constexpr int grid = 256;
    for (int i = 0; i < grid * grid; ++i) {
      const Vec2 u{(static_cast<float>(i % grid) + 0.5f) / grid,
                   (static_cast<float>(i / grid) + 0.5f) / grid};
      const Vec3 p(place.offset);  // the centre sees all of the inside
      const auto sample = scene.sample_light(light, p, u);
      ASSERT_TRUE(sample);
      const Ray ray{p, sample->wi};
      const auto surface = seen(scene, ray);
      ASSERT_TRUE(surface);
      sum +=
          sqr(static_cast<double>(sample->distance)) / std::abs(dot(sample->wi, surface->ng)) / sample->pdf;
    }
    EXPECT_NEAR(sum / (grid * grid) / area, 1, 2e-4) << c;
  }
}

TEST(AreaLight, ShinesOnlyFromItsOuterSideUnlessTwoSided) {
  for (const bool two_sided : {false, true}) {
    SceneDescription description = world_of(disk({0, 0, 0}, {0, 0, 1}, 1), {}, false, grey(3));
    description.shapes[0].two_sided = two_sided;
    const Scene scene(std::move(description));
    for (const float z : {2.0f, -2.0f}) {
      const Vec3 p{0.2f, 0.1f, z};
      const Ray ray{p, {0, 0, -z / 2}};
      const Surface surface = *seen(scene, ray);
      const bool is_lit = z > 0 || two_sided;
      EXPECT_EQ(scene.sample_light(light, p, {0.3f, 0.4f}).has_value(), is_lit);
      EXPECT_EQ(scene.emitted(surface, -ray.d), is_lit ? grey(3) : black);
      EXPECT_EQ(
          scene.light_pdf(LightSelection::power, {p, {0, 0, 1}}, surface, *scene.intersect(ray), ray.d) > 0,
          is_lit);
    }
    EXPECT_FALSE(scene.sample_light(light, {3, 0, 0}, {0.3f, 0.4f})) << "edge-on";
  }
}

TEST(AreaLight, HasNoDensityOfWhatIsNoLight) {
  SceneDescription description = world_of(disk({0, 0, 0}, {0, 0, 1}, 1), {}, false, grey(3));
  add_shape(description, disk({0, 0, 1}, {0, 0, 1}, 1), static_cast<MaterialId>(0));
  const Scene scene(std::move(description));
  const Ray ray{{0, 0, 5}, {0, 0, -1}};
  const Surface surface = *seen(scene, ray);
  EXPECT_EQ(surface.light, LightId::none);
  EXPECT_EQ(scene.light_pdf(LightSelection::power, {ray.o, {0, 0, 1}}, surface, *scene.intersect(ray), ray.d),
            0);
  EXPECT_TRUE(is_black(scene.emitted(surface, {0, 0, 1})));
}

}  // namespace
}  // namespace umbral
