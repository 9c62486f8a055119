// Scenes of pbrt and Mitsuba as parts of our own: everything moves together, and settings stay those of the scene.
#include "scene_folder.h"

namespace umbral {
namespace {

using test::contains;
using test::SceneFolder;

// Each holds a camera at (0, 1, 5) that looks at (0, 1, 0), 8 samples a pixel of 40 × 20, paths of one bounce, a triangle
// of "paint" at the corners (0, 0, 0), (1, 0, 0), (0, 1, 0), an object of the same triangle with an instance at
// (0, 0, −3), and lights: a point at (1, 2, 3), a distant one along −y, and an environment of radiance 2.
constexpr const char* pbrt = R"(LookAt 0 1 5  0 1 0  0 1 0
Camera "perspective" "float fov" 30
Film "rgb" "integer xresolution" 40 "integer yresolution" 20
Sampler "halton" "integer pixelsamples" 8
Integrator "path" "integer maxdepth" 1
WorldBegin
LightSource "point" "point3 from" [ 1 2 3 ]
LightSource "distant" "point3 from" [ 0 1 0 ] "point3 to" [ 0 0 0 ]
LightSource "infinite" "rgb L" [ 2 2 2 ]
MakeNamedMaterial "paint" "string type" "diffuse" "rgb reflectance" [ 0.25 0.25 0.25 ]
NamedMaterial "paint"
Shape "trianglemesh" "point3 P" [ 0 0 0  1 0 0  0 1 0 ] "integer indices" [ 0 1 2 ]
ObjectBegin "thing"
Shape "trianglemesh" "point3 P" [ 0 0 0  1 0 0  0 1 0 ] "integer indices" [ 0 1 2 ]
ObjectEnd
Translate 0 0 -3
ObjectInstance "thing"
)";

constexpr const char* mitsuba = R"(<scene version="3.0.0">
<integrator type="path"><integer name="max_depth" value="2"/></integrator>
<sensor type="perspective" id="front"><float name="fov" value="60"/>
  <transform name="to_world"><lookat origin="0,1,5" target="0,1,0" up="0,1,0"/></transform>
  <sampler type="independent"><integer name="sample_count" value="8"/></sampler>
  <film type="hdrfilm"><integer name="width" value="40"/><integer name="height" value="20"/></film></sensor>
<emitter type="point"><point name="position" value="1,2,3"/></emitter>
<emitter type="directional"><vector name="direction" value="0,-1,0"/></emitter>
<emitter type="constant"><rgb name="radiance" value="2"/></emitter>
<bsdf type="diffuse" id="paint"><rgb name="reflectance" value="0.25"/></bsdf>
<shape type="obj"><string name="filename" value="triangle.obj"/><ref id="paint"/></shape>
<shape type="shapegroup" id="thing">
  <shape type="obj"><string name="filename" value="triangle.obj"/><ref id="paint"/></shape></shape>
<shape type="instance"><ref id="thing"/>
  <transform name="to_world"><translate value="0,0,-3"/></transform></shape>
</scene>)";

struct Sample {
  const char *file, *text, *camera;
};

class IncludedScene : public testing::TestWithParam<Sample> {
 protected:
  void SetUp() override {
    folder.write("parts/triangle.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
    folder.write("parts/" + file, GetParam().text);
  }

  std::string include(const std::string& more = "") const {
    return "[[include]]\nfile = \"parts/" + file + "\"\n" + more;
  }

  const SceneFolder folder;
  const std::string file = GetParam().file;
};

void expect_point(const Vec3d& a, const Vec3d& b) {
  for (int c = 0; c < 3; ++c) EXPECT_NEAR(a[c], b[c], 1e-5) << c;
}

TEST_P(IncludedScene, MovesAsAWhole) {
  const SceneFile scene =
      folder.read_toml(include("transform = [{ scale = 2 }, { rotate = { axis = [0, 0, 1], degrees = 90 } }, "
                               "{ translate = [4, 5, 6] }]"));
  const Affine map = translation({4, 5, 6}) * rotation({0, 0, 1}, glm::radians(90.0)) * scaling({2, 2, 2});
  const CameraSettings& camera = scene.scene.camera;
  expect_point(Vec3d(camera.position), map.point({0, 1, 5}));
  expect_point(glm::normalize(Vec3d(camera.look_at) - Vec3d(camera.position)), {0, 0, -1});
  expect_point(Vec3d(camera.up), {-1, 0, 0});
  ASSERT_EQ(scene.cameras.size(), 1u);
  EXPECT_EQ(scene.cameras[0].name, GetParam().camera);
  EXPECT_EQ(scene.cameras[0].aspect, 2);

  ASSERT_EQ(scene.scene.shapes.size(), 1u);
  expect_point(Vec3d(std::get<Mesh>(scene.scene.shapes[0].kind).positions.at(1)), map.point({1, 0, 0}));
  ASSERT_EQ(scene.scene.instances.size(), 1u);
  expect_point(scene.scene.instances[0].to_world.point({1, 0, 0}), map.point({1, 0, -3}));
  expect_point(Vec3d(std::get<Mesh>(scene.scene.objects.at(0).shapes.at(0).kind).positions.at(1)), {1, 0, 0});

  ASSERT_EQ(scene.scene.lights.size(), 2u);
  expect_point(Vec3d(std::get<PointLight>(scene.scene.lights[0]).position), map.point({1, 2, 3}));
  expect_point(Vec3d(std::get<DistantLight>(scene.scene.lights[1]).direction), {1, 0, 0});
  ASSERT_TRUE(scene.scene.environment);
  EXPECT_NEAR(scene.scene.environment->radiance.g, 2, 1e-6);
}

TEST_P(IncludedScene, LeavesSettingsAndTheCameraToTheScene) {
  folder.write("scene.toml", "[film]\nwidth = 30\n[camera]\nposition = [0, 0, 9]\n" + include());
  test::StandInSettings settings;
  const SceneFile scene = read_scene_file(folder.path("scene.toml"), stand_in_integrators(settings));
  EXPECT_EQ(scene.film.width, 30);
  EXPECT_EQ(scene.sampling.spp, SamplingSettings{}.spp);
  EXPECT_EQ(settings.max_depth, 7);
  EXPECT_EQ(scene.scene.camera.position, Vec3(0, 0, 9));
  ASSERT_EQ(scene.cameras.size(), 1u);
  EXPECT_EQ(scene.cameras[0].settings.position, Vec3(0, 1, 5)) << "for --camera";
}

TEST_P(IncludedScene, TakesMaterialsByName) {
  const std::string red = "[materials.red]\ntype = \"matte\"\nreflectance = [1, 0, 0]\n";
  const auto reflectance = [&](const std::string& more) {
    const SceneFile scene = folder.read_toml(include(more) + red);
    return std::get<Lambert>(scene.scene.materials.at(index_of(scene.scene.shapes.at(0).material)).lobe)
        .reflectance;
  };
  EXPECT_EQ(reflectance("materials = { paint = \"red\" }\n"), rgb(1, 0, 0));
  EXPECT_EQ(reflectance("material = \"red\"\n"), rgb(1, 0, 0));
  EXPECT_EQ(folder.errors_of_toml(include("materials = { pant = \"red\" }\n") + red),
            "scene.toml:3:15: error: no face of the file uses a material 'pant'; did you mean 'paint'?\n"
            "    3 | materials = { pant = \"red\" }\n"
            "      |               ^");
}

TEST_P(IncludedScene, GivesWayToTheScenesOwnEnvironment) {
  const SceneFile scene = folder.read_toml(include() + "[[lights]]\ntype = \"environment\"\nradiance = 1\n");
  EXPECT_EQ(scene.scene.environment->radiance, grey(1));
  EXPECT_TRUE(
      contains(folder.warnings(scene), "scene.toml:3:1: warning: this environment takes the place of that"))
      << folder.warnings(scene);
}

TEST_P(IncludedScene, StandsInTheWorldAlone) {
  const std::string object =
      "[objects.pair]\ninclude = [{ file = \"parts/" + file + "\" }]\n[[instances]]\nobject = \"pair\"\n";
  const std::string errors = folder.errors_of_toml(object);
  EXPECT_TRUE(
      contains(errors, "scene.toml:2:21: error: a scene of pbrt or Mitsuba comes into the world alone"))
      << errors;
}

TEST_P(IncludedScene, ErrorsNameTheirFile) {
  const std::string text = GetParam().text;
  folder.write("parts/" + file, text.substr(0, text.find("paint") + 2));
  const std::string errors = folder.errors_of_toml(include());
  EXPECT_TRUE(contains(errors, "parts/" + file + ":")) << errors;
}

INSTANTIATE_TEST_SUITE_P(Formats, IncludedScene,
                         testing::Values(Sample{"world.pbrt", pbrt, "world"},
                                         Sample{"world.xml", mitsuba, "front"}),
                         [](const auto& sample) { return std::string(sample.param.camera); });

}  // namespace
}  // namespace umbral
