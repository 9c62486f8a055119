// Transforms, meshes, objects and includes of TOML scene files.
#include "scene_folder.h"

namespace umbral {
namespace {

using test::SceneFolder;

// To where the origin of a sphere's own space, and its x axis, go.
struct Moved {
  Vec3d origin, x;
};

Moved moved_by(const std::string& steps) {
  const SceneFolder folder;
  const SceneFile file =
      folder.read_toml("[[shapes]]\ntype = \"sphere\"\nemission = 1\ntransform = [" + steps + "]\n");
  const Affine& map = file.scene.shapes.at(0).to_world;
  return {map.point({0, 0, 0}), map.vector({1, 0, 0})};
}

void expect_near(const Vec3d& a, const Vec3d& b) {
  EXPECT_LT(glm::length(a - b), 1e-14) << a.x << " " << a.y << " " << a.z;
}

TEST(TomlTransform, StepsActInTheOrderWritten) {
  expect_near(moved_by("{ translate = [1, 0, 0] }, { scale = 2 }").origin, {2, 0, 0});
  expect_near(moved_by("{ scale = 2 }, { translate = [1, 0, 0] }").origin, {1, 0, 0});
  const Moved turned = moved_by(
      "{ translate = [1, 0, 0] }, { rotate = { axis = [0, 0, 3], degrees = 90 } }, { translate = [5, 0, 0] "
      "}");
  expect_near(turned.origin, {5, 1, 0});
  expect_near(turned.x, {0, 1, 0});
}

TEST(TomlTransform, EveryStepIsWhatItSays) {
  expect_near(moved_by("{ scale = [2, 3, 4] }").x, {2, 0, 0});
  expect_near(moved_by("{ rotate = { axis = [0, 1, 0], degrees = 90 } }").x, {0, 0, -1});
  const Moved moved = moved_by("{ matrix = [[1, 2, 3, 10], [4, 5, 6, 20], [7, 8, 10, 30], [0, 0, 0, 1]] }");
  expect_near(moved.x, {1, 4, 7});
  expect_near(moved.origin, {10, 20, 30});
}

TEST(TomlTransform, IsBakedIntoMeshes) {
  const SceneFolder folder;
  const SceneFile file = folder.read_toml(R"([[shapes]]
type = "mesh"
vertices = [[0, 0, 0], [1, 0, 0], [0, 1, 0]]
faces = [[0, 1, 2]]
normals = [[0, 0, 2], [0, 0, 2], [0, 0, 2]]
emission = 1
transform = [{ scale = [-1, 1, 1] }, { translate = [0, 0, 5] }]
)");
  const Shape& shape = file.scene.shapes.at(0);
  const Mesh& mesh = std::get<Mesh>(shape.kind);
  EXPECT_TRUE(shape.to_world.is_identity());
  EXPECT_EQ(mesh.positions[1], Vec3(-1, 0, 5));
  EXPECT_EQ(mesh.normals[0], Vec3(0, 0, 1));
  // The mirror turns the winding, so that the outer side stays the outer side.
  const glm::uvec3 t = mesh.triangles.at(0);
  EXPECT_GT(cross(mesh.positions[t.y] - mesh.positions[t.x], mesh.positions[t.z] - mesh.positions[t.x]).z, 0);
}

TEST(TomlMesh, PolygonsBecomeTriangles) {
  const SceneFolder folder;
  const SceneFile file = folder.read_toml(R"([[shapes]]
type = "mesh"
vertices = [[0, 0, 0], [4, 0, 0], [4, 4, 0], [2, 1, 0], [0, 4, 0]]
faces = [[0, 1, 2, 3, 4], [0, 4, 3]]
uvs = [[0, 0], [1, 0], [1, 1], [0.5, 0.25], [0, 1]]
emission = 1
)");
  const Mesh& mesh = std::get<Mesh>(file.scene.shapes.at(0).kind);
  EXPECT_EQ(mesh.triangles.size(), 4u);
  EXPECT_DOUBLE_EQ(mesh.area(), 10 + 4);  // of the concave pentagon and of the triangle
  EXPECT_EQ(mesh.uvs.at(3), Vec2(0.5f, 0.25f));
}

constexpr const char* two_materials =
    "[materials.red]\ntype = \"matte\"\nreflectance = [1, 0, 0]\n"
    "[materials.blue]\ntype = \"matte\"\nreflectance = [0, 0, 1]\n";

void write_obj(const SceneFolder& folder) {
  folder.write("models/two.obj",
               "mtllib two.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nusemtl first\nf 1 2 3\nusemtl second\nf 1 3 2\n");
  folder.write("models/two.mtl", "newmtl first\nKd 0.25 0.25 0.25\nnewmtl second\nKd 0 1 0\nKe 3 3 3\n");
}

Spectrum reflectance(const SceneFile& file, std::size_t shape) {
  const MaterialId material = file.scene.shapes.at(shape).material;
  return std::get<Lambert>(file.scene.materials.at(index_of(material)).lobe).reflectance;
}

TEST(TomlInclude, BringsShapesWithTheirMaterials) {
  const SceneFolder folder;
  write_obj(folder);
  const SceneFile file =
      folder.read_toml("[[include]]\nfile = \"models/two.obj\"\ntransform = [{ translate = [0, 0, 7] }]\n");
  ASSERT_EQ(file.scene.shapes.size(), 2u);
  EXPECT_EQ(reflectance(file, 0), grey(0.25f));
  EXPECT_EQ(reflectance(file, 1), rgb(0, 1, 0));
  EXPECT_EQ(file.scene.shapes[0].emission.value, black);
  EXPECT_EQ(file.scene.shapes[1].emission.value, grey(3));
  EXPECT_EQ(std::get<Mesh>(file.scene.shapes[0].kind).positions[0], Vec3(0, 0, 7));
}

TEST(TomlInclude, MaterialsCanBeReplacedAllOrByName) {
  const SceneFolder folder;
  write_obj(folder);
  const std::string include =
      std::string(two_materials) + "[[include]]\nfile = \"models/two.obj\"\nmaterial = \"red\"\n";
  const SceneFile both = folder.read_toml(include + "materials = { second = \"blue\" }\n");
  EXPECT_EQ(reflectance(both, 0), rgb(1, 0, 0));
  EXPECT_EQ(reflectance(both, 1), rgb(0, 0, 1));
  EXPECT_EQ(both.scene.shapes[1].emission.value, grey(3)) << "emission stays the file's";
  EXPECT_EQ(folder.errors_of_toml(include + "materials = { secnd = \"blue\" }\n"),
            "scene.toml:10:15: error: no face of the file uses a material 'secnd'; did you mean 'second'?\n"
            "   10 | materials = { secnd = \"blue\" }\n"
            "      |               ^");
}

TEST(TomlInclude, PlyFilesNeedAMaterial) {
  const SceneFolder folder;
  folder.write(
      "t.ply",
      "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\n"
      "element face 1\nproperty list uchar int vertex_indices\nend_header\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n");
  const SceneFile file =
      folder.read_toml("[materials.m]\ntype = \"matte\"\n[[include]]\nfile = \"t.ply\"\nmaterial = \"m\"\n");
  EXPECT_EQ(std::get<Mesh>(file.scene.shapes.at(0).kind).triangles.size(), 1u);
}

TEST(TomlObjects, StandWhereInstancesPutThem) {
  const SceneFolder folder;
  write_obj(folder);
  const SceneFile file = folder.read_toml(R"([materials.m]
type = "matte"
[objects.tree]
[[objects.tree.shapes]]
type = "sphere"
material = "m"
[[objects.tree.include]]
file = "models/two.obj"
[[instances]]
object = "tree"
[[instances]]
object = "tree"
transform = [{ translate = [1, 2, 3] }]
)");
  ASSERT_EQ(file.scene.objects.size(), 1u);
  EXPECT_EQ(file.scene.objects[0].name, "tree");
  EXPECT_EQ(file.scene.objects[0].shapes.size(), 3u);
  EXPECT_TRUE(file.scene.shapes.empty());
  ASSERT_EQ(file.scene.instances.size(), 2u);
  EXPECT_TRUE(file.scene.instances[0].to_world.is_identity());
  EXPECT_EQ(file.scene.instances[1].to_world.offset, Vec3d(1, 2, 3));
}

TEST(SceneHash, IsThatOfTheBytesAndNotOfThePaths) {
  const std::string scene =
      "[[shapes]]\ntype = \"sphere\"\nemission = { type = \"image\", file = \"t.tga\" }\n";
  const auto hash = [&](const std::string& text, std::uint8_t level) {
    const SceneFolder folder;  // another one each time
    folder.write("t.tga", test::tga(2, 2, level, level, level, 255));
    return folder.read_toml(text).hash;
  };
  EXPECT_EQ(hash(scene, 9), hash(scene, 9));
  EXPECT_NE(hash(scene, 9), hash(scene, 10));
  EXPECT_NE(hash(scene, 9), hash(scene + "# more\n", 9));
}

// Every tile beside the file, by the number in its name.
TEST(TomlScene, ImagesOfManyTiles) {
  const SceneFolder folder;
  folder.write("skin.1001.tga", test::tga(2, 2, 255, 0, 0, 255));
  folder.write("skin.1012.tga", test::tga(4, 2, 0, 255, 0, 255));
  const SceneFile file = folder.read_toml(
      "[[shapes]]\ntype = \"sphere\"\nemission = { type = \"image\", file = \"skin.<UDIM>.tga\" }\n");
  const Texture& texture = file.scene.textures.at(0);
  EXPECT_EQ(texture.color({0.5f, 0.5f}), Spectrum(1, 0, 0, 1));
  EXPECT_EQ(texture.color({1.5f, 1.5f}), Spectrum(0, 1, 0, 1));
  EXPECT_EQ(texture.color({1.5f, 0.5f}), Spectrum(0.0f));
  folder.write("none.toml",
               "[[shapes]]\ntype = \"sphere\"\nemission = { type = \"image\", file = \"no.<UDIM>.tga\" }\n");
  EXPECT_TRUE(
      test::contains(folder.errors("none.toml"), "there is no such file for any number from 1001 on"));
}

}  // namespace
}  // namespace umbral
