// OBJ files: what their statements mean, and what is said of broken ones.
#include "scene_folder.h"

namespace umbral {
namespace {

using test::contains;
using test::SceneFolder;

SceneFile read_obj(const SceneFolder& folder, const std::string& text) {
  folder.write("m.obj", text);
  return folder.read("m.obj");
}

Mesh only_mesh(const std::string& text) {
  const SceneFolder folder;
  const SceneFile file = read_obj(folder, text);
  EXPECT_EQ(file.scene.shapes.size(), 1u);
  return std::get<Mesh>(file.scene.shapes.at(0).kind);
}

std::string obj_errors(const std::string& text) {
  const SceneFolder folder;
  folder.write("m.obj", text);
  return folder.errors("m.obj");
}

constexpr const char* square = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n";

struct Form {
  const char* face;
  bool uvs, normals;
};

TEST(Obj, FacesOfEveryForm) {
  const std::string all = std::string(square) + "vt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\nvn 0 0 1\n";
  for (const Form& form : {Form{"f 1 2 3 4", false, false},
                           {"f 1/1 2/2 3/3 4/4", true, false},
                           {"f 1//1 2//1 3//1 4//1", false, true},
                           {"f 1/1/1 2/2/1 3/3/1 4/4/1", true, true},
                           {"f -4 -3 -2 -1", false, false},
                           {"f -4/-4/-1 -3/-3/-1 -2/-2/-1 -1/-1/-1", true, true},
                           {"f 1/ 2/ 3/ 4/", false, false},
                           {"f 1/1/ 2/2/ 3/3/ 4/4/", true, false},
                           {"fo 1 2 3 4", false, false},
                           {"  f\t1  2\t3 4 \r", false, false},
                           {"f 1 2 \\\n3 4", false, false},
                           {"f 1 2 \\\r\n3 4\r", false, false},
                           {"f 1 2 3 4 # all", false, false}}) {
    const Mesh mesh = only_mesh(all + form.face + "\n");
    EXPECT_EQ(mesh.positions.size(), 4u) << form.face;
    EXPECT_EQ(mesh.triangles.size(), 2u) << form.face;
    EXPECT_DOUBLE_EQ(mesh.area(), 1) << form.face;
    EXPECT_EQ(mesh.uvs.size(), form.uvs ? 4u : 0u) << form.face;
    EXPECT_EQ(mesh.normals.size(), form.normals ? 4u : 0u) << form.face;
  }
}

TEST(Obj, TheLastLineNeedsNoEnd) {
  EXPECT_EQ(only_mesh(std::string(square) + "f 1 2 3").triangles.size(), 1u);
}

TEST(Obj, AByteOrderMarkIsSkipped) {
  EXPECT_EQ(only_mesh(std::string("\xef\xbb\xbf") + square + "f 1 2 3").positions.size(), 3u);
}

TEST(Obj, FacesMayComeBeforeTheirVertices) {
  EXPECT_EQ(only_mesh(std::string("f 1 2 3\n") + square).triangles.size(), 1u);
}

TEST(Obj, NumbersOfEveryForm) {
  const Mesh mesh = only_mesh("v +1 .5 -.25e1\nv 1.e-2 2E+3 -0\nv 1e-60 0 7 0.5\nf 1 2 3\n");
  EXPECT_EQ(mesh.positions[0], Vec3(1, 0.5f, -2.5f));
  EXPECT_EQ(mesh.positions[1], Vec3(0.01f, 2000, 0));
  EXPECT_EQ(mesh.positions[2], Vec3(0, 0, 7));
}

TEST(Obj, VerticesAreSharedWhereAllOfThemIsTheSame) {
  const std::string corners = std::string(square) + "vt 0 0\nvt 1 1\n";
  EXPECT_EQ(only_mesh(corners + "f 1/1 2/1 3/1\nf 1/1 3/1 4/1\n").positions.size(), 4u);
  EXPECT_EQ(only_mesh(corners + "f 1/1 2/1 3/1\nf 1/2 3/1 4/1\n").positions.size(), 5u);
}

TEST(Obj, UvsAndNormalsBelongToTheirCorners) {
  const Mesh mesh = only_mesh(std::string(square) +
                              "vt 0.1 0.2\nvt 0.3 0.4\nvt 0.5\nvn 1 0 0\nvn 0 2 0\nvn 0 0 3\n"
                              "f 3/1/2 4/2/3 1/3/1\n");
  EXPECT_EQ(mesh.positions[0], Vec3(1, 1, 0));
  EXPECT_EQ(mesh.uvs[0], Vec2(0.1f, 0.2f));
  EXPECT_EQ(mesh.uvs[2], Vec2(0.5f, 0));
  EXPECT_EQ(mesh.normals[0], Vec3(0, 1, 0));
  EXPECT_EQ(mesh.normals[1], Vec3(0, 0, 1));
}

TEST(Obj, ConcavePolygonsKeepTheirArea) {
  const Mesh mesh = only_mesh(
      "v 0 0 1\nv 4 0 1\nv 4 1 1\nv 1 1 1\nv 1 3 1\nv 4 3 1\nv 4 4 1\nv 0 4 1\nf 1 2 3 4 5 6 7 8\n");
  EXPECT_EQ(mesh.triangles.size(), 6u);
  EXPECT_DOUBLE_EQ(mesh.area(), 10);
}

TEST(Obj, OneShapeForEachMaterial) {
  const SceneFolder folder;
  folder.write("m.mtl", "newmtl a\nKd 0.25 0.25 0.25\nnewmtl b c\nKd 0.75 0.75 0.75\n");
  const SceneFile file =
      read_obj(folder, "mtllib m.mtl\n" + std::string(square) +
                           "usemtl a\nf 1 2 3\nusemtl b c  \nf 1 3 4\no x\ng y\ns 1\nusemtl a\nf 2 3 4\n");
  ASSERT_EQ(file.scene.shapes.size(), 2u);
  EXPECT_EQ(file.scene.shapes[0].name, "a");
  EXPECT_EQ(file.scene.shapes[1].name, "b c");
  EXPECT_EQ(std::get<Mesh>(file.scene.shapes[0].kind).triangles.size(), 2u);
  EXPECT_EQ(file.scene.materials.size(), 2u);
}

TEST(Obj, FacesWithoutNormalsAreFlatBesideThoseThatHaveSome) {
  const SceneFolder folder;
  const std::string text = std::string(square) + "vn 0 0 1\nf 1//1 2//1 3//1\nf 1//1 3 4\n";
  const SceneFile file = read_obj(folder, text);
  ASSERT_EQ(file.scene.shapes.size(), 2u);
  EXPECT_EQ(std::get<Mesh>(file.scene.shapes[0].kind).normals.size(), 3u);
  EXPECT_TRUE(std::get<Mesh>(file.scene.shapes[1].kind).normals.empty());
  // As one mesh, they get the normal of their own plane.
  const SceneFile one = folder.read_toml("[[shapes]]\ntype = \"mesh\"\nfile = \"m.obj\"\nemission = 1\n");
  const Mesh& mesh = std::get<Mesh>(one.scene.shapes.at(0).kind);
  EXPECT_EQ(mesh.triangles.size(), 2u);
  ASSERT_EQ(mesh.normals.size(), 6u);
  EXPECT_EQ(mesh.normals[5], Vec3(0, 0, 1));
}

TEST(Obj, WhatIsLeftOutIsCounted) {
  const SceneFolder folder;
  const SceneFile file = read_obj(folder, std::string(square) +
                                              "v 2 2 2 0.5 0.5 0.5\nl 1 2\nl 2 3\np 1\nvp 1 2\ncurv 1 2\n"
                                              "f 1 2\nf 1 2 3\nf 1 2 2\nf 1 1 1 1\n");
  const std::string warnings = folder.warnings(file);
  EXPECT_TRUE(contains(warnings, "m.obj:6: warning: not used: 2 lines\n")) << warnings;
  EXPECT_TRUE(contains(warnings, "m.obj:8: warning: not used: 1 points\n")) << warnings;
  EXPECT_TRUE(contains(warnings, "m.obj:9: warning: not used: 1 'vp' statements\n")) << warnings;
  EXPECT_TRUE(contains(warnings, "m.obj:10: warning: not used: 1 'curv' statements\n")) << warnings;
  EXPECT_TRUE(contains(warnings, "m.obj:11: warning: not used: 1 faces of fewer than 3 corners\n"))
      << warnings;
  EXPECT_TRUE(contains(warnings, "m.obj:5: warning: not used: the colours or weights of 1 vertices\n"))
      << warnings;
  EXPECT_TRUE(contains(warnings, "m.obj:12: warning: mesh 'm.obj': dropped 3 triangles without area\n"))
      << warnings;
  EXPECT_TRUE(contains(warnings, "m.obj: warning: faces without a material are matte grey (0.5)\n"))
      << warnings;
}

TEST(Obj, NormalsWithoutDirectionAreReplaced) {
  const SceneFolder folder;
  const SceneFile file =
      read_obj(folder, std::string(square) + "vn 0 0 0\nvn nan 0 1\nvn 0 1 0\nf 1//1 2//2 3//3\n");
  const Mesh& mesh = std::get<Mesh>(file.scene.shapes.at(0).kind);
  EXPECT_EQ(mesh.normals, (std::vector<Vec3>{{0, 0, 1}, {0, 0, 1}, {0, 1, 0}}));
  EXPECT_TRUE(contains(folder.warnings(file), "replaced 2 normals without direction"));
}

TEST(Obj, MissingMaterialsAreGreyAndTold) {
  const SceneFolder folder;
  folder.write("m.mtl", "newmtl white\nKd 1 1 1\n");
  const SceneFile file =
      read_obj(folder, "mtllib m.mtl\nmtllib none.mtl\n" + std::string(square) + "usemtl wite\nf 1 2 3\n");
  const std::string warnings = folder.warnings(file);
  EXPECT_TRUE(contains(warnings,
                       "m.obj:2:8: warning: none.mtl: cannot be read: No such file or directory\n"
                       "    2 | mtllib none.mtl\n      |        ^\n"))
      << warnings;
  EXPECT_TRUE(contains(warnings,
                       "m.obj:7:8: warning: there is no material 'wite', so its faces are matte grey (0.5); "
                       "did you mean 'white'?\n    7 | usemtl wite\n      |        ^\n"))
      << warnings;
  EXPECT_EQ(std::get<Lambert>(file.scene.materials.at(0).lobe).reflectance, grey(0.5f));
}

TEST(Obj, LibrariesMayHaveSpacesOrBeSeveral) {
  const SceneFolder folder;
  folder.write("one lib.mtl", "newmtl a\nKd 1 0 0\n");
  folder.write("two.mtl", "newmtl b\nKd 0 1 0\n");
  for (const char* libraries : {"mtllib one lib.mtl\nmtllib two.mtl\n", "mtllib one\\ lib.mtl two.mtl\n"}) {
    const SceneFile file =
        read_obj(folder, libraries + std::string(square) + "usemtl a\nf 1 2 3\nusemtl b\nf 1 3 4\n");
    EXPECT_EQ(file.scene.materials.size(), 2u);
    EXPECT_FALSE(contains(folder.warnings(file), "there is no material")) << folder.warnings(file);
  }
}

TEST(Obj, GetsACameraAndALightWhereItHasNone) {
  const SceneFolder folder;
  const SceneFile dark = read_obj(folder, std::string(square) + "f 1 2 3\n");
  ASSERT_TRUE(dark.scene.environment);
  EXPECT_EQ(dark.scene.environment->radiance, grey(1));
  EXPECT_EQ(dark.scene.camera.look_at, Vec3(0.5f, 0.5f, 0));
  EXPECT_GT(dark.scene.camera.position.z, 1);
  EXPECT_EQ(dark.integrator, "path");
  EXPECT_TRUE(contains(
      folder.warnings(dark),
      "m.obj: warning: no light is given; a grey sky, brightest above to the left, lights the scene\n"));
  EXPECT_TRUE(
      contains(folder.warnings(dark), "m.obj: warning: no camera is given; it is put at [0.5, 0.5, "));
  folder.write("m.mtl", "newmtl lamp\nKe 5 5 5\n");
  EXPECT_FALSE(
      read_obj(folder, "mtllib m.mtl\nusemtl lamp\n" + std::string(square) + "f 1 2 3\n").scene.environment);
}

TEST(ObjErrors, HaveTheirPlace) {
  EXPECT_EQ(
      obj_errors("v 0 0 0\nv 1 0\nf 1 2 3\n"),
      "m.obj:2:6: error: 3 numbers are needed here\n    2 | v 1 0\n      |      ^\n"
      "m.obj:3:5: error: there is no number 2: the file has 1 vertices\n    3 | f 1 2 3\n      |     ^\n"
      "m.obj:3:7: error: there is no number 3: the file has 1 vertices\n    3 | f 1 2 3\n      |       ^");
  const std::string start = square;
  EXPECT_EQ(obj_errors(start + "f 1 2 x\n"),
            "m.obj:5:7: error: this is not the number of a vertex\n    5 | f 1 2 x\n      |       ^");
  EXPECT_EQ(obj_errors(start + "f 1 0 3\n"),
            "m.obj:5:5: error: numbers start from 1\n    5 | f 1 0 3\n      |     ^");
  EXPECT_EQ(obj_errors(start + "f 1 2 -5\n"),
            "m.obj:5:7: error: there is no vertex -5\n    5 | f 1 2 -5\n      |       ^");
  EXPECT_EQ(obj_errors(start + "f 1 2 99999999999\n"),
            "m.obj:5:7: error: there is no vertex 99999999999\n    5 | f 1 2 99999999999\n      |       ^");
  EXPECT_EQ(obj_errors(start + "f 1/1 2 3\n"),
            "m.obj:5:5: error: there is no number 1: the file has 0 texture coordinates\n"
            "    5 | f 1/1 2 3\n      |     ^");
  EXPECT_EQ(obj_errors(start + "f 1//-1 2 3\n"),
            "m.obj:5:6: error: there is no normal -1\n    5 | f 1//-1 2 3\n      |      ^");
  EXPECT_EQ(obj_errors(start + "f 1 2 3,4\n"),
            "m.obj:5:8: error: a corner of a face is written v, v/vt, v//vn or v/vt/vn\n"
            "    5 | f 1 2 3,4\n      |        ^");
  EXPECT_EQ(obj_errors("v 1 nan 0\n"),
            "m.obj:1:3: error: the vertex is not finite\n    1 | v 1 nan 0\n      |   ^");
  EXPECT_EQ(obj_errors("v 1 1e39 0\n"),
            "m.obj:1:3: error: the vertex is not finite\n    1 | v 1 1e39 0\n      |   ^");
  EXPECT_EQ(obj_errors("v 1 1.#IND 0\n"),
            "m.obj:1:5: error: this is not a number that can be computed with\n    1 | v 1 1.#IND 0\n      | "
            "    ^");
  EXPECT_EQ(obj_errors(start), "m.obj: error: the file has no face with an area");
  EXPECT_EQ(obj_errors(""), "m.obj: error: the file has no face with an area");
}

TEST(ObjErrors, AreNoMoreThanTwenty) {
  std::string text;
  for (int i = 0; i < 1000; ++i) text += "v x\n";
  const std::string errors = obj_errors(text);
  EXPECT_TRUE(
      contains(errors,
               "m.obj:20:3: error: this is not a number that can be computed with (what follows is not "
               "read)"))
      << errors;
  EXPECT_FALSE(contains(errors, "m.obj:21:"));
}

}  // namespace
}  // namespace umbral
