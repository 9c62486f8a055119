// Direct light of polygons, spheres and disks on a matte floor: form factors at every pixel.
#include <array>

#include "support/oracles.h"
#include "support/render_image.h"
#include "support/scene_kit.h"
#include "support/truth.h"
#include "support/ways.h"

namespace umbral::test {
namespace {

const Vec3d albedo(0.3, 0.6, 0.9), radiance(2, 1, 0.5), up(0, 0, 1);

// A small floor around `at`, seen straight from above: from afar, or from below what hangs over it.
struct LitFloor {
  SceneDescription description;
  MaterialId black_material;

  LitFloor(const Vec3& at, float height, float fov) {
    description.camera = camera(at + Vec3{0, 0, height}, at, fov, {0, 1, 0});
    add_shape(description, rectangle(at - Vec3{0.48f, 0.48f, 0}, {0.96f, 0, 0}, {0, 0.96f, 0}),
              add_matte(description, Spectrum(Vec3(albedo), 0)));
    black_material = add_matte(description, black);
  }

  Shape& add(ShapeKinds light) {
    return add_shape(description, std::move(light), black_material, Spectrum(Vec3(radiance), 0));
  }
};

constexpr Way ways[] = {{Strategy::mis, SamplerKind::sobol},
                        {Strategy::bsdf, SamplerKind::sobol},
                        {Strategy::light, SamplerKind::sobol},
                        {Strategy::mis, SamplerKind::independent}};

class LightShapeOracle : public testing::TestWithParam<int> {
 protected:
  // `form_factor` of the light seen from a point of the floor; `spp` of each way.
  testing::AssertionResult agrees(LitFloor floor, const std::array<int, 4>& spp,
                                  const std::function<double(const Vec3d&)>& form_factor) {
    const PixelImage truth = true_image(floor.description.camera, 16, 4, [&](const DoubleRay& ray) {
      return albedo * radiance * form_factor(on_plane(ray, {0, 0, 0}, up));
    });
    const Scene scene(std::move(floor.description));
    const Way& way = ways[GetParam()];
    PathIntegrator path = way.path();
    path.max_depth = 1;
    return agrees_with(truth,
                       SmallRender{scene, path, way.sampler, spp[static_cast<std::size_t>(GetParam())]});
  }
};

// Half of it below the horizon of the floor.
TEST_P(LightShapeOracle, Rectangle) {
  const Vec3 origin{0.9f, -1.5f, -1}, across{0.3f, 3, 0}, upwards{0.2f, 0, 3};
  LitFloor floor({0, 0, 0}, 6, 8);
  floor.add(rectangle(origin, upwards, across));  // faces −x
  const Vec3d a(origin), b(origin + upwards), c(origin + upwards + across), d(origin + across);
  EXPECT_TRUE(agrees(std::move(floor), {32, 256, 32, 320}, [&](const Vec3d& p) {
    return polygon_form_factor(p, up, {a, b, c, d});
  }));
}

TEST_P(LightShapeOracle, PentagonOfTriangles) {
  std::vector<Vec3> corners{
      {0.2f, -1, 0}, {-1.2f, -0.7f, 0}, {-1.5f, 0.9f, 0}, {0.1f, 1.6f, 0}, {1.2f, 0.3f, 0}};
  for (Vec3& corner : corners) corner.z = 1.25f + 0.25f * corner.x;
  LitFloor floor({0, 0.2f, 0}, 0.8f, 60);
  floor.add(polygon(corners));
  const std::vector<Vec3d> vertices(corners.begin(), corners.end());
  EXPECT_TRUE(agrees(std::move(floor), {32, 96, 32, 96},
                     [&](const Vec3d& p) { return polygon_form_factor(p, up, vertices); }));
}

TEST_P(LightShapeOracle, SphereAbove) {
  LitFloor floor({0, 0, 0}, 0.6f, 70);
  floor.add(sphere({0.5f, 0.2f, 2.2f}, 1.5f));
  EXPECT_TRUE(agrees(std::move(floor), {64, 96, 256, 400}, [](const Vec3d& p) {
    return sphere_form_factor(p, up, Vec3d(Vec3(0.5f, 0.2f, 2.2f)), 1.5);
  }));
}

// Its horizon is cut by that of the floor.
TEST_P(LightShapeOracle, SphereAtTheHorizon) {
  LitFloor floor({0.3f, 0, 0}, 6, 4);
  floor.add(sphere({2.0f, 0.3f, 0.5f}, 1.2f));
  EXPECT_TRUE(agrees(std::move(floor), {128, 160, 480, 1600}, [](const Vec3d& p) {
    return sphere_form_factor(p, up, Vec3d(Vec3(2.0f, 0.3f, 0.5f)), static_cast<double>(1.2f));
  }));
}

TEST_P(LightShapeOracle, Disk) {
  LitFloor floor({0.6f, 0, 0}, 0.8f, 60);
  floor.add(disk({0, 0, 1}, {0, 0, -1}, 1.2f));
  EXPECT_TRUE(agrees(std::move(floor), {32, 64, 32, 160}, [](const Vec3d& p) {
    return disk_form_factor(1, std::hypot(p.x, p.y), static_cast<double>(1.2f));
  }));
}

INSTANTIATE_TEST_SUITE_P(Ways, LightShapeOracle, testing::Range(0, 4),
                         [](const auto& tested) { return name_of(ways[tested.param]); });

}  // namespace
}  // namespace umbral::test
