// Attributes of PLY meshes that Mitsuba's textures look at: of vertices and of faces, of one number and of three.
#include "scene_folder.h"

namespace umbral {
namespace {

using test::contains;
using test::SceneFolder;

// Two triangles over one square. Whole numbers of an attribute are shares of 255, those of colours sRGB codes.
constexpr const char* square =
    "ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\nproperty float y\nproperty float z\n"
    "property uchar red\nproperty uchar green\nproperty uchar blue\nproperty float heat_0\nproperty uchar "
    "paint_r\nproperty uchar paint_g\nproperty uchar paint_b\nelement face 2\nproperty list uchar int "
    "vertex_indices\nproperty float weight_0\nproperty float color_0\nproperty float color_1\nproperty float "
    "color_2\nend_header\n"
    "0 0 0 255 0 0 .1 51 0 255\n1 0 0 0 255 0 .2 51 0 255\n1 1 0 0 0 255 .3 51 0 255\n0 1 0 0 0 0 .4 51 0 "
    "255\n"
    "3 0 1 2 .25 .1 .2 .3\n3 0 2 3 .75 .4 .5 .6\n";

std::string scene_of(const std::string& bsdf) {
  return "<scene version='3.0.0'><shape type='ply'><string name='filename' value='m.ply'/>" + bsdf +
         "</shape></scene>";
}

std::string attribute(const std::string& name, const std::string& use = "reflectance") {
  return "<texture type='mesh_attribute' name='" + use + "'><string name='name' value='" + name +
         "'/></texture>";
}

std::string diffuse(const std::string& attribute_name) {
  return "<bsdf type='diffuse'>" + attribute(attribute_name) + "</bsdf>";
}

struct MitsubaAttributes : testing::Test {
  SceneFolder folder;
  MitsubaAttributes() { folder.write("m.ply", square); }

  SceneFile read(const std::string& bsdf) const {
    folder.write("scene.xml", scene_of(bsdf));
    return folder.read("scene.xml");
  }
  // Of every vertex of the mesh.
  std::vector<Vec3> colors(const std::string& bsdf) const {
    const SceneFile file = read(bsdf);
    std::vector<Vec3> colors;
    for (const Spectrum& color : std::get<Mesh>(file.scene.shapes.at(0).kind).colors)
      colors.emplace_back(color);
    return colors;
  }
};

TEST_F(MitsubaAttributes, OfOneNumberAreGrey) {
  EXPECT_EQ(colors(diffuse("vertex_heat")),
            (std::vector<Vec3>{Vec3(0.1f), Vec3(0.2f), Vec3(0.3f), Vec3(0.4f)}));
  const Vec3 first(0.25f), second(0.75f);
  EXPECT_EQ(colors(diffuse("face_weight")), (std::vector<Vec3>{first, first, first, second, second, second}));
}

TEST_F(MitsubaAttributes, OfThreeNumbersAreColours) {
  EXPECT_EQ(colors(diffuse("vertex_paint")), std::vector<Vec3>(4, Vec3(0.2f, 0, 1)));
  const Vec3 first(0.1f, 0.2f, 0.3f), second(0.4f, 0.5f, 0.6f);
  EXPECT_EQ(colors(diffuse("face_color")), (std::vector<Vec3>{first, first, first, second, second, second}));
  EXPECT_EQ(colors(diffuse("vertex_color")).at(1), Vec3(0, 1, 0));
}

// Where Mitsuba's own test of blends has it.
TEST_F(MitsubaAttributes, MayWeighABlend) {
  const SceneFile file =
      read("<bsdf type='blendbsdf'>" + attribute("face_weight", "weight") +
           "<bsdf type='diffuse'/><bsdf type='diffuse'><rgb name='reflectance' value='0, 1, "
           "0'/></bsdf></bsdf>");
  const auto& mesh = std::get<Mesh>(file.scene.shapes.at(0).kind);
  ASSERT_EQ(mesh.colors.size(), 6u);
  const Material& mix = file.scene.materials.at(index_of(file.scene.shapes.at(0).material));
  ASSERT_EQ(mix.maps.size(), 1u);
  TexturePoint point;
  point.color = mesh.colors[5];
  EXPECT_NEAR(file.scene.textures.at(index_of(mix.maps[0].texture)).number(point), 0.75, 1e-6);
}

TEST_F(MitsubaAttributes, MayBeScaled) {
  const SceneFile file = read(
      "<bsdf type='diffuse'><texture type='mesh_attribute' name='reflectance'><string "
      "name='name' value='vertex_heat'/><float name='scale' value='2'/></texture></bsdf>");
  const Material& matte = file.scene.materials.at(index_of(file.scene.shapes.at(0).material));
  TexturePoint point;
  point.color = std::get<Mesh>(file.scene.shapes.at(0).kind).colors.at(3);
  EXPECT_NEAR(file.scene.textures.at(index_of(matte.maps.at(0).texture)).color(point).g, 0.8, 1e-6);
}

TEST_F(MitsubaAttributes, ThatAreNotThereAreTold) {
  const auto errors = [&](const std::string& bsdf) {
    folder.write("scene.xml", scene_of(bsdf));
    return folder.errors("scene.xml");
  };
  EXPECT_TRUE(contains(errors(diffuse("face_heat")), "the mesh has no attribute 'face_heat'"));
  EXPECT_TRUE(contains(errors(diffuse("vertex_weight")), "the mesh has no attribute 'vertex_weight'"));
  EXPECT_TRUE(contains(errors(diffuse("color")), "begins with 'vertex_' or 'face_', not as 'color'"));
  EXPECT_TRUE(contains(errors("<bsdf type='blendbsdf'>" + attribute("face_weight", "weight") +
                              diffuse("vertex_color") + "<bsdf type='diffuse'/></bsdf>"),
                       "not supported: two attributes of a mesh on one surface"));
}

}  // namespace
}  // namespace umbral
