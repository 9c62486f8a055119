// STL files, ASCII and binary.
#include "formats/stl/stl_reader.h"
#include "scene_folder.h"

namespace umbral {
namespace {

Mesh read(const std::string& bytes, std::vector<std::string>* warnings = nullptr) {
  std::vector<std::string> ignored;
  return read_stl(std::make_shared<const SourceText>("a.stl", bytes), warnings ? *warnings : ignored);
}

std::string error_of(const std::string& bytes) {
  try {
    read(bytes);
  } catch (const SceneError& error) {
    return error.what();
  }
  return "no error";
}

std::string binary(const std::string& title, std::size_t told, const std::vector<float>& facets) {
  std::string bytes = title;
  bytes.resize(80, ' ');
  const auto count = static_cast<std::uint32_t>(told);
  bytes.append(reinterpret_cast<const char*>(&count), 4);
  for (std::size_t i = 0; i < facets.size(); i += 12) {
    bytes.append(reinterpret_cast<const char*>(&facets[i]), 48);
    bytes.append(2, '\0');
  }
  return bytes;
}

const std::vector<float> one_facet{0, 0, 0, 0, 0, 5, 1, 0, 5, 0, 1, 5};

constexpr const char* ascii =
    "solid two words\n facet normal 0 0 0\n  outer loop\n   VERTEX 0 0 5\n   vertex 1e0 0 5\n   vertex 0 +1 "
    "5\n"
    "  endloop\n endfacet\nendsolid two words\nsolid\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 "
    "0 0\n"
    "vertex 1 1 0\nendloop\nendfacet\nendsolid\n";

TEST(Stl, BinaryEvenIfItBeginsWithSolid) {
  for (const char* title : {"made by a program", "solid made by a program"}) {
    const Mesh mesh = read(binary(title, 1, one_facet));
    EXPECT_EQ(mesh.positions, (std::vector<Vec3>{{0, 0, 5}, {1, 0, 5}, {0, 1, 5}})) << title;
    EXPECT_EQ(mesh.triangles, (std::vector<glm::uvec3>{{0, 1, 2}}));
  }
}

TEST(Stl, AsciiWithSeveralSolids) {
  const Mesh mesh = read(ascii);
  ASSERT_EQ(mesh.triangles.size(), 2u);
  EXPECT_EQ(mesh.positions[1], Vec3(1, 0, 5));
  EXPECT_DOUBLE_EQ(mesh.area(), 1);
  EXPECT_TRUE(mesh.normals.empty());
}

TEST(Stl, BrokenFilesAreLocated) {
  EXPECT_EQ(error_of(binary("x", 2, one_facet)), "a.stl: error: the file is cut: it has 1 facets of 2");
  EXPECT_EQ(error_of("abc"), "a.stl: error: a binary STL file begins with 84 bytes, but it has 3");
  EXPECT_EQ(error_of("solid\nfacet\nvertex 0 0 x\n"),
            "a.stl:3:1: error: a vertex needs three numbers\n    3 | vertex 0 0 x\n      | ^");
  EXPECT_NE(error_of(std::string(ascii).substr(0, 80)), "no error");
  EXPECT_NE(error_of("solid\nfacet\nvertex 0 0 0\nendfacet\n"), "no error");
  EXPECT_NE(error_of("solid\nhello\n"), "no error");
  std::vector<float> infinite = one_facet;
  infinite[5] = infinity;
  EXPECT_EQ(error_of(binary("x", 1, infinite)),
            "a.stl: error: 1 of its 3 corners are infinite or not numbers");
  std::vector<std::string> warnings;
  read(binary("x", 1, one_facet) + "more", &warnings);
  EXPECT_EQ(warnings, std::vector<std::string>{"4 bytes behind its 1 facets are not used"});
}

TEST(Stl, IsASceneByItselfAndAMeshOfAScene) {
  const test::SceneFolder folder;
  folder.write("a.stl", ascii);
  const SceneFile alone = folder.read("a.stl");
  EXPECT_EQ(alone.scene.shapes.size(), 1u);
  EXPECT_TRUE(test::contains(folder.warnings(alone), "the file names no material")) << folder.warnings(alone);
  const SceneFile scene = folder.read_toml(
      "[[shapes]]\ntype = \"mesh\"\nfile = \"a.stl\"\nemission = 1\n[[include]]\nfile = \"a.stl\"\nmaterial "
      "= \"m\"\n"
      "[materials.m]\ntype = \"matte\"\n");
  EXPECT_EQ(scene.scene.shapes.size(), 2u);
}

}  // namespace
}  // namespace umbral
