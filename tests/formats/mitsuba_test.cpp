// Scenes of Mitsuba: what their objects become.
#include "scene_folder.h"

namespace umbral {
namespace {

using test::contains;
using test::SceneFolder;

struct MitsubaFolder : SceneFolder {
  SceneFile read_xml(const std::string& content, const ReadOptions& options = {}) const {
    write("scene.xml", "<scene version='3.0.0'>\n" + content + "\n</scene>");
    test::StandInSettings settings;
    return read_scene_file(path("scene.xml"), test::stand_in_integrators(settings), options);
  }
  std::string errors_of_xml(const std::string& content) const {
    write("scene.xml", "<scene version='3.0.0'>\n" + content + "\n</scene>");
    return errors("scene.xml");
  }
};

const Material& material_of(const SceneFile& file, std::size_t shape) {
  return file.scene.materials.at(index_of(file.scene.shapes.at(shape).material));
}

void expect_near(const Vec3& a, const Vec3& b, float tolerance = 1e-5f) {
  EXPECT_LT(glm::length(a - b), tolerance) << a.x << ' ' << a.y << ' ' << a.z;
}

const std::string sphere = "<shape type='sphere'/>";

std::string sphere_of(const std::string& bsdf) {
  return "<shape type='sphere'><bsdf type='" + bsdf + "</bsdf></shape>\n";
}

TEST(Mitsuba, SensorFilmSamplerAndIntegrator) {
  const MitsubaFolder folder;
  folder.write("scene.xml",
               "<scene version='3.0.0'><default name='spp' value='12'/>"
               "<integrator type='moment'><integrator type='path'><integer name='max_depth' value='6'/>"
               "</integrator></integrator>"
               "<sensor type='perspective'><float name='fov' value='60'/>"
               "<transform name='to_world'><lookat origin='1 2 3' target='1, 2, -7' up='0,1,0'/></transform>"
               "<sampler type='independent'><integer name='sample_count' value='$spp'/></sampler>"
               "<film type='hdrfilm'><integer name='width' value='400'/><integer name='height' value='200'/>"
               "<rfilter type='box'/></film></sensor>" +
                   sphere + "</scene>");
  test::StandInSettings settings;
  const SceneFile file = read_scene_file(folder.path("scene.xml"), test::stand_in_integrators(settings));
  EXPECT_EQ(file.film.width, 400);
  EXPECT_EQ(file.film.height, 200);
  EXPECT_EQ(file.film.filter, FilterKind::box);
  EXPECT_EQ(file.sampling.spp, 12);
  EXPECT_EQ(settings.max_depth, 5) << "Mitsuba counts the light that is seen";
  const CameraSettings& camera = file.scene.camera;
  expect_near(camera.position, {1, 2, 3});
  expect_near(glm::normalize(camera.look_at - camera.position), {0, 0, -1});
  EXPECT_FALSE(camera.mirrored);
  EXPECT_NEAR(camera.fov, glm::degrees(2 * std::atan(std::tan(glm::radians(30.0)) / 2)), 1e-4)
      << "its fov is that of the width";
}

TEST(Mitsuba, ParametersComeFromTheCommandLine) {
  const MitsubaFolder folder;
  const std::string text =
      "<default name='r' value='2'/><shape type='sphere'><float name='radius' value='${r}5'/></shape>";
  EXPECT_EQ(std::get<Sphere>(folder.read_xml(text).scene.shapes.at(0).kind).radius, 25);
  ReadOptions options;
  options.definitions["r"] = "3";
  EXPECT_EQ(std::get<Sphere>(folder.read_xml(text, options).scene.shapes.at(0).kind).radius, 35);
  options.definitions["s"] = "3";
  EXPECT_THROW(folder.read_xml(text, options), SceneError);
}

TEST(Mitsuba, TransformsFollowEachOther) {
  const MitsubaFolder folder;
  const SceneFile file = folder.read_xml(
      "<shape type='rectangle'><transform name='to_world'><scale value='2'/><rotate z='1' angle='90'/>"
      "<translate x='5'/></transform></shape>"
      "<shape type='rectangle'><transform name='toWorld'>"
      "<matrix value='0 -1 0 7 1 0 0 8 0 0 1 9 0 0 0 1'/></transform></shape>");
  const auto at = [&](std::size_t shape, const Vec3d& p) {
    return Vec3(file.scene.shapes.at(shape).to_world.point(p));
  };
  expect_near(at(0, {1, 0, 0}), {5, 2, 0});
  expect_near(at(1, {1, 0, 0}), {7, 9, 9});
}

TEST(Mitsuba, ShapesOfEachKind) {
  const MitsubaFolder folder;
  folder.write("a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0.25 0.25\nf 1/1 2/1 3/1\n");
  const SceneFile file = folder.read_xml(
      "<shape type='sphere'><point name='center' x='1' y='2' z='3'/><float name='radius' value='4'/></shape>"
      "<shape type='rectangle'/><shape type='disk'/><shape type='cube'/>"
      "<shape type='cylinder'><point name='p0' value='0 0 -1'/><float name='radius' value='.5'/></shape>"
      "<shape type='obj'><string name='filename' value='a.obj'/></shape>"
      "<shape type='rectangle'><boolean name='flip_normals' value='true'/></shape>");
  const Shape& ball = file.scene.shapes.at(0);
  expect_near(Vec3(ball.to_world.point(Vec3d(1, 2, 7))), {1, 2, -1});
  EXPECT_EQ(std::get<Cylinder>(file.scene.shapes.at(4).kind).bottom, Vec3(0, 0, -1));
  const Mesh& cube = std::get<Mesh>(file.scene.shapes.at(3).kind);
  EXPECT_EQ(cube.triangles.size(), 12u);
  EXPECT_NEAR(cube.area(), 24, 1e-5);
  for (const glm::uvec3& t : cube.triangles) {
    const Vec3 a = cube.positions[t.x], b = cube.positions[t.y], c = cube.positions[t.z];
    EXPECT_GT(dot(cross(b - a, c - a), a + b + c), 0) << "the faces of a cube face outwards";
  }
  EXPECT_EQ(std::get<Mesh>(file.scene.shapes.at(5).kind).uvs[0], Vec2(0.25f, 0.75f));
  const Rectangle& turned = std::get<Rectangle>(file.scene.shapes.at(6).kind);
  EXPECT_LT(cross(turned.edge_u, turned.edge_v).z, 0);
}

TEST(Mitsuba, MaterialsBecomeLobes) {
  const MitsubaFolder folder;
  const SceneFile file = folder.read_xml(
      "<bsdf type='diffuse' id='red'><rgb name='reflectance' value='.6, .1, .2'/></bsdf>"
      "<shape type='sphere'><ref id='red'/></shape>\n" +
      sphere_of("twosided'><ref id='red'/>") +
      sphere_of("mask'><float name='opacity' value='.25'/><bsdf type='diffuse'><rgb name='reflectance' "
                "value='#ffffff'/></bsdf>") +
      sphere_of("roughconductor'><string name='distribution' value='ggx'/><float name='alpha' value='.09'/>"
                "<string name='material' value='Au'/>") +
      sphere_of("conductor'>") +
      sphere_of("dielectric'><float name='int_ior' value='1.6'/><string name='extIOR' value='vacuum'/>") +
      sphere_of("thindielectric'>") +
      sphere_of(
          "roughplastic'><string name='distribution' value='ggx'/><boolean name='nonlinear' value='true'/>"
          "<rgb name='diffuse_reflectance' value='.5'/>") +
      sphere_of("plastic'>") + sphere_of("null'>") + sphere);
  ASSERT_EQ(file.scene.shapes.size(), 10u) << "nothing is seen of a null surface";
  EXPECT_EQ(std::get<Lambert>(material_of(file, 0).lobe).reflectance, rgb(.6f, .1f, .2f));
  EXPECT_EQ(material_of(file, 0).name, "red");
  EXPECT_EQ(std::get<Lambert>(material_of(file, 1).lobe).reflectance, rgb(.6f, .1f, .2f));
  EXPECT_FLOAT_EQ(material_of(file, 2).alpha.value, 0.25f);
  EXPECT_EQ(std::get<Lambert>(material_of(file, 2).lobe).reflectance, white);
  EXPECT_NEAR(std::get<Conductor>(material_of(file, 3).lobe).roughness, 0.3, 1e-6);
  EXPECT_EQ(std::get<Conductor>(material_of(file, 3).lobe).metal, Metal::Au);
  EXPECT_TRUE(std::holds_alternative<Mirror>(material_of(file, 4).lobe));
  EXPECT_NEAR(std::get<Dielectric>(material_of(file, 5).lobe).eta, 1.6, 1e-6);
  EXPECT_NEAR(std::get<ThinDielectric>(material_of(file, 6).lobe).eta, 1.5046 / 1.000277, 1e-6);
  EXPECT_NEAR(std::get<Plastic>(material_of(file, 7).lobe).reflectance.g, 0.5, 1e-6);
  EXPECT_EQ(std::get<Lambert>(material_of(file, 9).lobe).reflectance, grey(0.5f));
}

TEST(Mitsuba, PrincipledIsReadAsTheOneHere) {
  const MitsubaFolder folder;
  const SceneFile file = folder.read_xml(
      sphere_of("principled'><rgb name='base_color' value='.8 .2 .1'/><float name='metallic' value='.25'/>"
                "<float name='roughness' value='.3'/><float name='clearcoat' value='1'/>"));
  const Principled& lobe = std::get<Principled>(material_of(file, 0).lobe);
  EXPECT_EQ(lobe.base_color, rgb(.8f, .2f, .1f));
  EXPECT_FLOAT_EQ(lobe.metallic, .25f);
  EXPECT_FLOAT_EQ(lobe.roughness, .3f);
  EXPECT_FLOAT_EQ(lobe.clearcoat, 1);
  EXPECT_NEAR(lobe.ior, 1.5, 1e-3) << "specular 0.5 is a reflectance of 0.04";
  EXPECT_TRUE(contains(folder.warnings(file), "stands in for Mitsuba's"));
}

// The albedo of the body alone: ρ (1 − K)/(1 − ρK) of the file's ρ without the ρ in the denominator.
TEST(Mitsuba, LinearPlasticsReflectAsMuchAsTheyDoThere) {
  const MitsubaFolder folder;
  const SceneFile file = folder.read_xml(sphere_of(
      "plastic'><rgb name='diffuse_reflectance' value='.1 .27 .9'/><float name='int_ior' value='1.9'/>"));
  const Plastic& lobe = std::get<Plastic>(material_of(file, 0).lobe);
  const float k = lobe.internal_reflectance();
  const float expected[3] = {.1f, .27f, .9f};
  for (int c = 0; c < 3; ++c)
    EXPECT_NEAR(lobe.reflectance[c] / (1 - lobe.reflectance[c] * k), expected[c] / (1 - k), 1e-4);
  // The internal diffuse reflectance at index 1.9/1.000277, by quadrature of Fresnel's equations.
  EXPECT_NEAR(k, 0.7624, 0.002);
}

TEST(Mitsuba, EmittersInTheirUnits) {
  const MitsubaFolder folder;
  const SceneFile file = folder.read_xml(
      "<emitter type='point'><point name='position' value='1 2 3'/><rgb name='intensity' "
      "value='300'/></emitter>"
      "<emitter type='point'><transform name='to_world'><translate z='10'/></transform></emitter>"
      "<emitter type='directional'><vector name='direction' value='0,0,2'/><rgb name='irradiance' value='1 2 "
      "3'/></emitter>"
      "<emitter type='constant'><spectrum name='radiance' value='2'/></emitter>"
      "<shape type='sphere'><emitter type='area'><rgb name='radiance' value='17, 12, 4'/></emitter></shape>");
  EXPECT_EQ(std::get<PointLight>(file.scene.lights.at(0)).intensity, grey(300));
  expect_near(std::get<PointLight>(file.scene.lights.at(1)).position, {0, 0, 10});
  EXPECT_EQ(std::get<DistantLight>(file.scene.lights.at(2)).direction, Vec3(0, 0, 1));
  EXPECT_EQ(std::get<DistantLight>(file.scene.lights.at(2)).irradiance, rgb(1, 2, 3));
  // A flat spectrum is the white E, which is redder than the white of RGB.
  ASSERT_TRUE(file.scene.environment);
  expect_near(Vec3(file.scene.environment->radiance), {2 * 1.2048f, 2 * 0.9483f, 2 * 0.9089f}, 0.005f);
  EXPECT_EQ(file.scene.shapes.at(0).emission.value, rgb(17, 12, 4));
}

// v of an image is 0 at its upper edge there and at its lower edge here.
TEST(Mitsuba, ImagesAreTurnedOver) {
  const MitsubaFolder folder;
  folder.write("t.tga", test::tga(2, 2, 255, 255, 255, 255));
  const SceneFile file = folder.read_xml(
      sphere_of("diffuse'><texture name='reflectance' type='bitmap'><string name='filename' value='t.tga'/>"
                "<string name='wrap_mode' value='mirror'/><string name='filter_type' value='nearest'/>"
                "<transform name='to_uv'><scale value='2'/><translate value='-.5,-.25, "
                "0'/></transform></texture>") +
      sphere_of("diffuse'><texture name='reflectance' type='checkerboard'><rgb name='color0' value='.1'/>"
                "<float name='uscale' value='8'/></texture>"));
  const auto& image = std::get<ImageTexture>(file.scene.textures.at(0).kind);
  EXPECT_EQ(image.wrap, Wrap::mirror);
  EXPECT_EQ(image.filter, TextureFilter::nearest);
  for (const Vec2 uv : {Vec2(0, 0), Vec2(0.3f, 0.8f)}) {
    const Vec2 there = 2.0f * uv + Vec2(-0.5f, -0.25f);
    EXPECT_LT(glm::length(image.uv_map(uv) - Vec2(there.x, 1 - there.y)), 1e-6f);
  }
  const auto& checker = std::get<CheckerTexture>(file.scene.textures.at(1).kind);
  EXPECT_EQ(checker.even, grey(0.1f));
  EXPECT_EQ(checker.uv_scale, Vec2(16, 2));
}

TEST(Mitsuba, GroupsStandWhereTheirInstancesAre) {
  const MitsubaFolder folder;
  const SceneFile file = folder.read_xml(
      "<shape type='instance'><ref id='group'/></shape>"
      "<shape type='shapegroup' id='group'><shape type='sphere'/><shape type='cube'/></shape>"
      "<shape type='instance'><ref id='group'/><transform name='to_world'><translate "
      "z='2'/></transform></shape>");
  ASSERT_EQ(file.scene.objects.size(), 1u);
  EXPECT_EQ(file.scene.objects[0].shapes.size(), 2u);
  ASSERT_EQ(file.scene.instances.size(), 2u);
  EXPECT_EQ(file.scene.instances[1].to_world.offset, Vec3d(0, 0, 2));
  EXPECT_TRUE(file.scene.shapes.empty());
}

TEST(Mitsuba, FilesIncludeOthersAndLookInPaths) {
  const MitsubaFolder folder;
  folder.write("common/meshes/a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
  folder.write("parts/ball.xml",
               "<scene version='2.0.0'><shape type='obj'><string name='filename' "
               "value='meshes/a.obj'/></shape></scene>");
  EXPECT_EQ(folder.read_xml("<path value='common'/><include filename='parts/ball.xml'/>").scene.shapes.size(),
            1u);
  folder.write("parts/ball.xml", "<scene version='2.0.0'><include filename='parts/ball.xml'/></scene>");
  EXPECT_TRUE(contains(folder.errors("scene.xml"), "include each other"));
}

TEST(Mitsuba, MistakesAreToldWithTheirPlace) {
  const MitsubaFolder folder;
  const std::string unknown =
      folder.errors_of_xml("<shape type='sphere'>\n  <float name='radios' value='1'/></shape>");
  EXPECT_TRUE(
      contains(unknown, "scene.xml:3:4: error: 'sphere' has no property 'radios'; did you mean 'radius'?"))
      << unknown;
  for (const auto& [text, message] : std::vector<std::pair<std::string, std::string>>{
           {"<shape type='sphere'>", "this is no XML"},
           {"<shape type='sphere'><ref id='x'/></shape>", "nothing with the id 'x'"},
           {"<shape type='sphere'><float name='radius' value='abc'/></shape>", "must be a number, not 'abc'"},
           {"<shape type='sphere'><float name='radius' value='-1'/></shape>", "must be above 0"},
           {"<shape type='sphere'><string name='radius' value='1'/></shape>",
            "must be a <float>, not a <string>"},
           {"<shape type='$what'/>", "'$what' has no value"},
           {"<shape type='cube'><transform name='to_world'><scale value='0'/></transform></shape>",
            "determinant is 0"},
           {"<shape type='cube'><transform name='to_world'><turn/></transform></shape>",
            "<turn> is no transform"},
           {"<shape type='obj'><string name='filename' value='none.obj'/></shape>", "cannot be read"},
           {"<shape type='instance'/>", "wants a <ref>"},
           {sphere_of("diffuse'><rgb name='reflectance' value='1 2'/>"), "is no colour"},
           {sphere_of("dielectric'><string name='int_ior' value='diamant'/>"), "did you mean 'diamond'?"},
           {sphere_of("twosided'>"), "wants a BSDF"}})
    EXPECT_TRUE(contains(folder.errors_of_xml(text), message)) << text << "\n" << folder.errors_of_xml(text);
}

TEST(Mitsuba, WhatIsNotSupportedIsRefusedOrLeftOut) {
  const MitsubaFolder folder;
  const std::string text = "<shape type='bsplinecurve'/>\n" + sphere_of("hair'>") +
                           sphere_of("roughconductor'><string name='material' value='a-C'/>");
  const std::string refused = folder.errors_of_xml(text);
  EXPECT_TRUE(contains(refused, "scene.xml:2:2: error: not supported: a shape of type 'bsplinecurve'"))
      << refused;
  EXPECT_TRUE(contains(refused, "not supported: the metal 'a-C'")) << refused;
  ReadOptions lenient;
  lenient.lenient = true;
  const SceneFile file = folder.read_xml(text, lenient);
  EXPECT_EQ(file.scene.shapes.size(), 2u);
  EXPECT_EQ(file.left_out.size(), 3u);
}

// Where no 'twosided' stands, Mitsuba's surfaces are black from behind.
TEST(Mitsuba, SurfacesAreBlackFromBehind) {
  const MitsubaFolder folder;
  const SceneFile file =
      folder.read_xml(sphere_of("diffuse'>") + sphere_of("twosided'><bsdf type='diffuse'/>") +
                      sphere_of("dielectric'>") + sphere);
  const BackSide expected[] = {BackSide::absorbing, BackSide::same, BackSide::same, BackSide::absorbing};
  for (std::size_t i = 0; i < 4; ++i) EXPECT_EQ(material_of(file, i).back, expected[i]) << i;
}

TEST(Mitsuba, NormalsBumpsAndColoursOfVertices) {
  const MitsubaFolder folder;
  folder.write("t.tga", test::tga(2, 2, 128, 128, 255, 255));
  const std::string image =
      "type='bitmap'><string name='filename' value='t.tga'/><boolean name='raw' value='true'/></texture>";
  const SceneFile file =
      folder.read_xml(sphere_of("normalmap'><texture name='normalmap' " + image + "<bsdf type='plastic'/>") +
                      sphere_of("bumpmap'><texture name='x' " + image +
                                "<float name='scale' value='3'/><bsdf type='diffuse'/>") +
                      sphere_of("diffuse'><texture name='reflectance' type='mesh_attribute'><string "
                                "name='name' value='vertex_color'/></texture>") +
                      sphere_of("normalmap'><texture name='normalmap' " + image +
                                "<bsdf type='principled'><float name='clearcoat' value='1'/></bsdf>"));
  EXPECT_TRUE(material_of(file, 0).has_normal_map());
  EXPECT_EQ(material_of(file, 3).clearcoat_normal_map, material_of(file, 3).normal_map)
      << "all layers have it";
  EXPECT_TRUE(std::holds_alternative<Plastic>(material_of(file, 0).lobe));
  EXPECT_TRUE(material_of(file, 1).has_bump_map());
  EXPECT_EQ(material_of(file, 1).bump_scale, 3);
  ASSERT_EQ(material_of(file, 2).maps.size(), 1u);
  EXPECT_TRUE(std::holds_alternative<VertexColorTexture>(
      file.scene.textures.at(index_of(material_of(file, 2).maps[0].texture)).kind));
}

}  // namespace
}  // namespace umbral
