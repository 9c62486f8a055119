// Furnaces: closed surfaces of one emission and one albedo, and clear glass in even light.
#include <fmt/format.h>

#include "support/render_image.h"
#include "support/scene_kit.h"
#include "support/truth.h"
#include "support/ways.h"

namespace umbral::test {
namespace {

const Vec3d albedo_of_furnace(0.2, 0.4, 0.6), emission_of_furnace(0.5, 1, 2);

enum class Hull { sphere, box, torus, ellipsoid };

// A closed hull around the camera that shines to both sides.
SceneDescription furnace(Hull hull) {
  SceneDescription scene;
  const MaterialId material = add_matte(scene, Spectrum(Vec3(albedo_of_furnace), 0));
  const Spectrum emission(Vec3(emission_of_furnace), 0);
  scene.camera = camera({0.3f, 0.2f, -0.1f}, {1, 0.1f, 0.2f}, 80);
  switch (hull) {
    case Hull::sphere:
      add_shape(scene, sphere({0.1f, 0, 0.2f}, 1), material, emission);
      break;
    case Hull::box:
      add_shape(scene, box({-1, -0.7f, -1.3f}, {0.9f, 1, 0.8f}), material, emission);
      break;
    case Hull::torus:
      add_shape(scene, torus(1, 0.4f), material, emission);
      scene.camera = camera({1.1f, 0, 0.1f}, {0.6f, 1, 0}, 80);
      break;
    case Hull::ellipsoid: {  // unevenly scaled, mirrored and instanced
      add_shape(scene, sphere({0, 0, 0}, 0.5f), material, emission);
      scene.objects.push_back({"hull", std::move(scene.shapes)});
      scene.shapes.clear();
      const Affine turned = rotation(glm::normalize(Vec3d(1, 2, 3)), 0.7);
      scene.instances.push_back({static_cast<ObjectId>(0), turned * scaling({-2, 3, 1.4})});
    }
  }
  for (Shape& shape : scene.shapes) shape.two_sided = true;
  for (Object& object : scene.objects) object.shapes.front().two_sided = true;
  return scene;
}

PixelImage even_image(const Vec3d& radiance) { return {16, 16, std::vector<Vec3d>(256, radiance)}; }

struct Case {
  Hull hull;
  Way way;
  int spp;
};

class FurnaceOracle : public testing::TestWithParam<Case> {};

std::string case_name(const testing::TestParamInfo<Case>& tested) {
  static constexpr const char* names[] = {"sphere", "box", "torus", "ellipsoid"};
  return std::string(names[static_cast<int>(tested.param.hull)]) + "_" + name_of(tested.param.way);
}

// L = Le/(1 − ρ).
TEST_P(FurnaceOracle, AllBounces) {
  const auto& [hull, way, spp] = GetParam();
  const Scene scene(furnace(hull));
  PathIntegrator path = way.path();
  EXPECT_TRUE(agrees_with(even_image(emission_of_furnace / (1.0 - albedo_of_furnace)),
                          SmallRender{scene, path, way.sampler, spp}));
}

constexpr Way way(Strategy strategy, SamplerKind sampler) { return {strategy, sampler}; }
constexpr auto sobol = SamplerKind::sobol, independent = SamplerKind::independent;

// Light samples alone have no bound in the corners of the box, and so no place here.
INSTANTIATE_TEST_SUITE_P(Hulls, FurnaceOracle,
                         testing::Values(Case{Hull::sphere, way(Strategy::mis, sobol), 32},
                                         Case{Hull::sphere, way(Strategy::bsdf, independent), 80},
                                         Case{Hull::sphere, way(Strategy::light, sobol), 32},
                                         Case{Hull::box, way(Strategy::mis, sobol), 48},
                                         Case{Hull::box, way(Strategy::mis, independent), 64},
                                         Case{Hull::box, way(Strategy::bsdf, sobol), 48},
                                         Case{Hull::torus, way(Strategy::mis, sobol), 40},
                                         Case{Hull::torus, way(Strategy::bsdf, independent), 80},
                                         Case{Hull::torus, way(Strategy::light, sobol), 100},
                                         Case{Hull::ellipsoid, way(Strategy::mis, independent), 64},
                                         Case{Hull::ellipsoid, way(Strategy::light, sobol), 48}),
                         case_name);

class BouncesOracle : public testing::TestWithParam<std::tuple<int, Way>> {};

// L = Le (1 − ρ^(k+1))/(1 − ρ) for k bounces, with roulette from the first bounce on.
TEST_P(BouncesOracle, OfTheSphereFurnace) {
  const auto& [bounces, way] = GetParam();
  const Scene scene(furnace(Hull::sphere));
  PathIntegrator path = way.path();
  path.max_depth = bounces;
  path.roulette_depth = 0;
  const Vec3d sum = (1.0 - pow(albedo_of_furnace, Vec3d(bounces + 1.0))) / (1.0 - albedo_of_furnace);
  EXPECT_TRUE(agrees_with(even_image(emission_of_furnace * sum),
                          SmallRender{scene, path, way.sampler, bounces > 2 ? 80 : 32}));
}

INSTANTIATE_TEST_SUITE_P(Depths, BouncesOracle,
                         testing::Combine(testing::Values(1, 2, 5),
                                          testing::Values(way(Strategy::mis, sobol),
                                                          way(Strategy::light, independent),
                                                          way(Strategy::bsdf, sobol))),
                         [](const auto& tested) {
                           return fmt::format("{}_{}", std::get<0>(tested.param),
                                              name_of(std::get<1>(tested.param)));
                         });

// Even light goes through a lossless dielectric unchanged. Inside, radiance is η² times as high.
class GlassOracle : public testing::TestWithParam<SamplerKind> {};

SceneDescription glass(const CameraSettings& view) {
  SceneDescription scene;
  scene.camera = view;
  add_shape(scene, sphere({0, 0, 0}, 1), add_material(scene, Dielectric{1.5f}));
  scene.environment.emplace();
  scene.environment->radiance = rgb(0.5f, 1, 2);
  scene.environment->prepare();
  return scene;
}

TEST_P(GlassOracle, ChangesNothingOutside) {
  const Scene scene(glass(camera({0, -3, 0}, {0, 0, 0}, 45)));
  PathIntegrator path;
  EXPECT_TRUE(agrees_with(even_image({0.5, 1, 2}), SmallRender{scene, path, GetParam(), 32}));
}

TEST_P(GlassOracle, HoldsEtaSquaredInside) {
  const Scene scene(glass(camera({0.3f, -0.2f, 0}, {0, 1, 0}, 70)));
  PathIntegrator path;
  EXPECT_TRUE(agrees_with(even_image(2.25 * Vec3d(0.5, 1, 2)), SmallRender{scene, path, GetParam(), 32}));
}

INSTANTIATE_TEST_SUITE_P(Samplers, GlassOracle, testing::Values(sobol, independent), [](const auto& tested) {
  return sampler_names()[static_cast<std::size_t>(tested.param)];
});

}  // namespace
}  // namespace umbral::test
