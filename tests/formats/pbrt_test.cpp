// Scenes of pbrt-v4: what their directives become.
#include "pbrt_kit.h"

namespace umbral {
namespace {

using test::contains;
using test::expect_near;
using test::lobe_of;
using test::mesh_of;
using test::pbrt_errors;
using test::read_pbrt;
using test::SceneFolder;
using test::square;

// Which way the first triangle faces.
Vec3 facing(const Mesh& mesh) {
  const glm::uvec3 t = mesh.triangles.at(0);
  const Vec3 a = mesh.positions[t.x];
  return glm::normalize(cross(mesh.positions[t.y] - a, mesh.positions[t.z] - a));
}

TEST(Pbrt, FilmSamplerFilterAndDepthAreTheScenesSettings) {
  const SceneFolder folder;
  folder.write(
      "scene.pbrt",
      "Film \"rgb\" \"integer xresolution\" [ 320 ] \"integer yresolution\" 200 \"string filename\" \"x\"\n"
      "Sampler \"stratified\" \"integer xsamples\" 3 \"integer ysamples\" 5\n"
      "PixelFilter \"triangle\" \"float xradius\" 1.5 \"float yradius\" 1.5\n"
      "Integrator \"volpath\" \"integer maxdepth\" 13 # as many bounces\n"
      "WorldBegin\n" +
          std::string(square));
  test::StandInSettings settings;
  const SceneFile file = read_scene_file(folder.path("scene.pbrt"), test::stand_in_integrators(settings));
  EXPECT_EQ(file.film.width, 320);
  EXPECT_EQ(file.film.height, 200);
  EXPECT_EQ(file.film.filter, FilterKind::tent);
  EXPECT_EQ(file.film.filter_radius, 1.5f);
  EXPECT_EQ(file.sampling.spp, 15);
  EXPECT_EQ(file.integrator, "path");
  EXPECT_EQ(settings.max_depth, 13);
  EXPECT_EQ(settings.reads["local"], 1);
}

TEST(Pbrt, WhatTheFileLeavesOpenIsWhatPbrtTakes) {
  const SceneFolder folder;
  folder.write("scene.pbrt", std::string("WorldBegin\n") + square);
  test::StandInSettings settings;
  const SceneFile file = read_scene_file(folder.path("scene.pbrt"), test::stand_in_integrators(settings));
  EXPECT_EQ(file.film.width, 1280);
  EXPECT_EQ(file.film.height, 720);
  EXPECT_EQ(file.sampling.spp, 16);
  EXPECT_EQ(settings.max_depth, 5);
  EXPECT_EQ(std::get<Lambert>(lobe_of(file, 0)).reflectance, grey(0.5f));
}

// LookAt has x to the right of a viewer for whom y is up and z ahead: that is a left-handed world.
TEST(Pbrt, CamerasAreLeftHanded) {
  const SceneFolder folder;
  const std::string look = "LookAt 1 2 3  1 2 -7  0 1 0\n";
  const std::string camera = "Camera \"perspective\" \"float fov\" 40\n";
  const SceneFile plain = read_pbrt(folder, square, look + camera);
  EXPECT_TRUE(plain.scene.camera.mirrored);
  expect_near(plain.scene.camera.position, {1, 2, 3});
  expect_near(glm::normalize(plain.scene.camera.look_at - plain.scene.camera.position), {0, 0, -1});
  expect_near(plain.scene.camera.up, {0, 1, 0});
  const SceneFile flipped = read_pbrt(folder, square, "Scale -1 1 1\n" + look + camera);
  EXPECT_FALSE(flipped.scene.camera.mirrored);
  expect_near(flipped.scene.camera.position, {1, 2, 3});
}

TEST(Pbrt, FovIsThatOfTheShorterSide) {
  const SceneFolder folder;
  const auto fov = [&](const char* film, const char* more) {
    return read_pbrt(
               folder, square,
               std::string("Film \"rgb\" ") + film + "\nCamera \"perspective\" \"float fov\" 60 " + more)
        .scene.camera;
  };
  EXPECT_NEAR(fov("\"integer xresolution\" 400 \"integer yresolution\" 200", "").fov, 60, 1e-4);
  // tan 30° is half the width now; the height is twice that.
  const float tall = fov("\"integer xresolution\" 200 \"integer yresolution\" 400", "").fov;
  EXPECT_NEAR(tall, glm::degrees(2 * std::atan(2 * std::tan(glm::radians(30.0)))), 1e-4);
  // The upper right quarter of the screen, whose middle is half a height up and right of the axis.
  const CameraSettings part =
      fov("\"integer xresolution\" 200 \"integer yresolution\" 200", "\"float screenwindow\" [ 0 1 0 1 ]");
  EXPECT_NEAR(part.fov, glm::degrees(2 * std::atan(std::tan(glm::radians(30.0)) / 2)), 1e-4);
  EXPECT_NEAR(part.shift.x, 0.5, 1e-6);
  EXPECT_NEAR(part.shift.y, 0.5, 1e-6);
}

TEST(Pbrt, TransformsGoInOrderAndAttributesEnd) {
  const SceneFolder folder;
  const SceneFile file =
      read_pbrt(folder,
                "Translate 5 0 0\nAttributeBegin\nScale 2 2 2\nRotate 90 0 0 1\n"
                "Shape \"sphere\"\nAttributeEnd\nShape \"sphere\" \"float radius\" 3\n"
                "CoordinateSystem \"here\"\nIdentity\nShape \"sphere\"\n"
                "CoordSysTransform \"here\"\nShape \"sphere\"\n"
                "Transform [ 0 1 0 0  -1 0 0 0  0 0 1 0  7 8 9 1 ]\nShape \"sphere\"\n"
                "ConcatTransform [ 2 0 0 0  0 2 0 0  0 0 2 0  1 0 0 1 ]\nShape \"sphere\"\n");
  const auto at = [&](std::size_t shape, const Vec3d& p) {
    return Vec3(file.scene.shapes.at(shape).to_world.point(p));
  };
  expect_near(at(0, {1, 0, 0}), {5, 2, 0});
  EXPECT_EQ(std::get<Sphere>(file.scene.shapes[1].kind).radius, 3);
  expect_near(at(1, {1, 0, 0}), {6, 0, 0});
  expect_near(at(2, {1, 0, 0}), {1, 0, 0});
  expect_near(at(3, {1, 0, 0}), {6, 0, 0});
  expect_near(at(4, {1, 0, 0}), {7, 9, 9});
  expect_near(at(5, {0, 0, 0}), {7, 9, 9});
}

// The side that shines is that of the vertices' normals, where there are any, and else that of the winding.
TEST(Pbrt, MeshesFaceTheirNormals) {
  const SceneFolder folder;
  const std::string down = "\"normal N\" [ 0 0 -1  0 0 -1  0 0 -1  0 0 -1 ]\n", turn = "ReverseOrientation\n";
  const std::string with = std::string(square, std::strlen(square) - 1) + " " + down;
  const SceneFile file = read_pbrt(folder, square + with + "AttributeBegin\nScale 1 1 -1\n" + square + with +
                                               "AttributeEnd\n" + turn + square + with);
  const float z[] = {1, -1, -1, 1, -1, 1};
  ASSERT_EQ(file.scene.shapes.size(), 6u);
  for (std::size_t i = 0; i < 6; ++i) {
    SCOPED_TRACE(i);
    expect_near(facing(mesh_of(file, i)), {0, 0, z[i]});
    if (i % 2 == 1) {
      expect_near(mesh_of(file, i).normals[0], {0, 0, z[i]});
    }
  }
}

TEST(Pbrt, ShapesOfEachKind) {
  const SceneFolder folder;
  const SceneFile file =
      read_pbrt(folder,
                "Shape \"disk\" \"float radius\" 2 \"float height\" 3\n"
                "Shape \"cylinder\" \"float radius\" .5 \"float zmin\" -1 \"float zmax\" 4\n"
                "Shape \"bilinearmesh\" \"point3 P\" [ 0 0 0  1 0 0  0 1 0  1 1 0 ]\n"
                "Shape \"bilinearmesh\" \"point3 P\" [ 0 0 0  1 0 0  0 1 0  1 1 1 ]\n"
                "Shape \"loopsubdiv\" \"integer levels\" 1 \"integer indices\" [ 0 2 1 0 1 3 1 2 3 2 0 3 ]"
                " \"point3 P\" [ 0 0 0 1 0 0 0 1 0 0 0 1 ]\n"
                "ReverseOrientation Shape \"disk\"\n");
  const Disk& disk = std::get<Disk>(file.scene.shapes.at(0).kind);
  EXPECT_EQ(disk.radius, 2);
  EXPECT_EQ(disk.center, Vec3(0, 0, 3));
  const Cylinder& cylinder = std::get<Cylinder>(file.scene.shapes.at(1).kind);
  EXPECT_EQ(cylinder.bottom, Vec3(0, 0, -1));
  EXPECT_EQ(cylinder.top, Vec3(0, 0, 4));
  EXPECT_EQ(mesh_of(file, 2).triangles.size(), 2u);
  EXPECT_EQ(mesh_of(file, 2).uvs[3], Vec2(1, 1));
  expect_near(facing(mesh_of(file, 2)), {0, 0, 1});
  EXPECT_EQ(mesh_of(file, 3).triangles.size(), 512u);
  EXPECT_TRUE(contains(folder.warnings(file), "16 × 16")) << folder.warnings(file);
  EXPECT_EQ(mesh_of(file, 4).triangles.size(), 16u);
  const Shape& turned = file.scene.shapes.at(5);
  EXPECT_LT(inverse(turned.to_world).transposed({0, 0, 1}).z, 0);
}

TEST(Pbrt, ObjectsStandWhereTheirInstancesAre) {
  const SceneFolder folder;
  const SceneFile file =
      read_pbrt(folder,
                "ObjectBegin \"ball\" Translate 0 0 1 Shape \"sphere\" ObjectEnd\n"
                "Translate 1 0 0 ObjectInstance \"ball\" Translate 1 0 0 ObjectInstance \"ball\"\n");
  ASSERT_EQ(file.scene.objects.size(), 1u);
  ASSERT_EQ(file.scene.objects[0].shapes.size(), 1u);
  ASSERT_EQ(file.scene.instances.size(), 2u);
  EXPECT_EQ(file.scene.objects[0].shapes[0].to_world.offset, Vec3d(0, 0, 1));
  EXPECT_EQ(file.scene.instances[1].to_world.offset, Vec3d(2, 0, 0));
}

TEST(Pbrt, FilesIncludeOthers) {
  const SceneFolder folder;
  folder.write("part/move.pbrt", "Translate 1 0 0\nShape \"sphere\"\n");
  const SceneFile file = read_pbrt(
      folder, "Include \"part/move.pbrt\" Shape \"sphere\" Import \"part/move.pbrt\" Shape \"sphere\"");
  std::vector<double> x;
  for (const Shape& shape : file.scene.shapes) x.push_back(shape.to_world.offset.x);
  EXPECT_EQ(x, (std::vector<double>{1, 1, 2, 1}));
  folder.write("part/move.pbrt", "Include \"part/move.pbrt\"");
  EXPECT_TRUE(contains(folder.errors("scene.pbrt"), "include each other")) << folder.errors("scene.pbrt");
}

TEST(Pbrt, AttributesSetDefaults) {
  const SceneFolder folder;
  const SceneFile file = read_pbrt(folder,
                                   "AttributeBegin Attribute \"shape\" \"float radius\" 4 Shape \"sphere\""
                                   " Shape \"sphere\" \"float radius\" 2 AttributeEnd Shape \"sphere\"");
  std::vector<float> radii;
  for (const Shape& shape : file.scene.shapes) radii.push_back(std::get<Sphere>(shape.kind).radius);
  EXPECT_EQ(radii, (std::vector<float>{4, 2, 1}));
}

TEST(Pbrt, MistakesAreToldWithTheirPlace) {
  const SceneFolder folder;
  EXPECT_EQ(pbrt_errors(folder, "WorldBegin\nShap \"sphere\""),
            "scene.pbrt:2:1: error: there is no directive 'Shap'; did you mean 'Shape'?\n"
            "    2 | Shap \"sphere\"\n"
            "      | ^");
  const std::string unknown = pbrt_errors(folder, "WorldBegin\nShape \"sphere\" \"float radios\" 1");
  EXPECT_TRUE(contains(unknown, "scene.pbrt:2:17")) << unknown;
  EXPECT_TRUE(contains(unknown, "no parameter 'radios'; did you mean 'radius'?")) << unknown;
  for (const auto& [text, message] : std::vector<std::pair<std::string, std::string>>{
           {"WorldBegin Shape \"sphere\" \"integer radius\" 1", "must be \"float radius\""},
           {"WorldBegin Shape \"sphere\" \"float radius\" [ 1 2 ]", "wants 1 value, not 2"},
           {"WorldBegin Shape \"sphere\" \"float radius\" -1", "a radius must be above 0"},
           {"WorldBegin Shape \"sphere", "has no end in its line"},
           {"WorldBegin Shape \"sphere\" \"float radius\" [ 1", "the file ends within"},
           {"WorldBegin Scale 0 1 1 ", "flattens everything"},
           {"WorldBegin Transform [ 1 0 0 0 0 1 0 0 0 0 0 0 0 0 0 1 ]", "determinant is 0"},
           {"WorldBegin AttributeEnd", "has no Begin"},
           {"WorldBegin NamedMaterial \"x\"", "there is no material 'x'"},
           {"WorldBegin ObjectInstance \"x\"", "there is no object 'x'"},
           {"Shape \"sphere\"", "must stand after WorldBegin"},
           {"WorldBegin Shape \"plymesh\" \"string filename\" \"none.ply\"", "cannot be read"},
           {"WorldBegin Shape \"trianglemesh\" \"point3 P\" [ 0 0 0 1 0 0 0 1 0 ] \"integer indices\" [ 0 1 "
            "3 ]",
            "index 3 names no vertex"},
           {"WorldBegin Shape \"loopsubdiv\" \"integer levels\" 14 \"point3 P\" [ 0 0 0 1 0 0 0 1 0 ] "
            "\"integer "
            "indices\" [ 0 1 2 ]",
            "make more than"},
           {"WorldBegin Material \"diffuse\" \"texture reflectance\" \"a\" Shape \"sphere\"",
            "there is no spectrum texture 'a'"},
           {"WorldBegin Texture \"a\" \"spectrum\" \"scale\" \"texture tex\" \"a\"\n"
            "Material \"diffuse\" \"texture reflectance\" \"a\" Shape \"sphere\"",
            "made of itself"}})
    EXPECT_TRUE(contains(pbrt_errors(folder, text), message)) << text << "\n" << pbrt_errors(folder, text);
}

TEST(Pbrt, WhatIsNotSupportedIsRefusedOrLeftOut) {
  const SceneFolder folder;
  const std::string text =
      "WorldBegin\nMakeNamedMedium \"fog\" \"string type\" \"homogeneous\"\n"
      "Shape \"curve\" \"point3 P\" [ 0 0 0 1 0 0 1 1 0 1 1 1 ]\n"
      "MediumInterface \"fog\" \"\"\nMaterial \"hair\"\nShape \"sphere\"\nLightSource \"laser\"\n";
  const std::string refused = pbrt_errors(folder, text);
  EXPECT_TRUE(contains(refused, "scene.pbrt:3:1: error: not supported: a shape of type 'curve'; --lenient"))
      << refused;
  EXPECT_TRUE(contains(refused,
                       "scene.pbrt:4:1: error: not supported: the medium 'fog', which does more than absorb"))
      << refused;
  test::StandInSettings settings;
  ReadOptions lenient;
  lenient.lenient = true;
  const SceneFile file =
      read_scene_file(folder.path("scene.pbrt"), test::stand_in_integrators(settings), lenient);
  EXPECT_EQ(file.scene.shapes.size(), 1u);
  ASSERT_EQ(file.left_out.size(), 4u);
  EXPECT_TRUE(contains(file.left_out[0], "scene.pbrt:3: a shape of type 'curve'")) << file.left_out[0];
  EXPECT_TRUE(contains(folder.warnings(file), "left out: a material of type 'hair'"));
}

}  // namespace
}  // namespace umbral
