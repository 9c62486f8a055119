// Materials that are made of others: in scene files, and as pbrt and Mitsuba write them.
#include "scene_folder.h"

namespace umbral {
namespace {

using test::contains;
using test::SceneFolder;

const Material& material_of(const SceneFile& file, std::size_t shape) {
  return file.scene.materials.at(index_of(file.scene.shapes.at(shape).material));
}
const Material& part_of(const SceneFile& file, const Material& material, std::size_t part) {
  return file.scene.materials.at(index_of(material.parts.at(part).material));
}

SceneFile read(const SceneFolder& folder, const std::string& name, const std::string& text) {
  folder.write(name, text);
  return folder.read(name);
}
std::string errors(const SceneFolder& folder, const std::string& name, const std::string& text) {
  folder.write(name, text);
  return folder.errors(name);
}

SceneFile read_pbrt(const SceneFolder& folder, const std::string& world) {
  return read(folder, "scene.pbrt", "WorldBegin\n" + world);
}

SceneFile read_mitsuba(const SceneFolder& folder, const std::string& bsdf) {
  return read(folder, "scene.xml",
              "<scene version='3.0.0'><shape type='sphere'>" + bsdf + "</shape></scene>");
}

// What a part is made of stands before it, wherever it is written.
TEST(MixedMaterials, OfSceneFilesNameTheirParts) {
  const SceneFolder folder;
  const SceneFile file = folder.read_toml(R"([[shapes]]
type = "sphere"
material = "car"
[materials.car]
type = "coat"
base = "dirty"
roughness = 0.1
[materials.dirty]
type = "mix"
a = "paint"
b = "dust"
amount = { type = "checker" }
[materials.paint]
type = "plastic"
[materials.dust]
type = "matte"
)");
  const Material& car = material_of(file, 0);
  EXPECT_EQ(car.name, "car");
  EXPECT_FLOAT_EQ(std::get<Coat>(car.lobe).roughness, 0.1f);
  const Material& dirty = part_of(file, car, 0);
  EXPECT_EQ(dirty.name, "dirty");
  EXPECT_EQ(dirty.maps.size(), 1u);
  EXPECT_EQ(part_of(file, dirty, 0).name, "paint");
  EXPECT_EQ(part_of(file, dirty, 1).name, "dust");
  for (std::size_t i = 0; i < file.scene.materials.size(); ++i)
    for (const MaterialPart& part : file.scene.materials[i].parts) EXPECT_LT(index_of(part.material), i);
}

TEST(MixedMaterials, OfPbrtTakeTheSecondByTheirAmount) {
  const SceneFolder folder;
  const SceneFile file =
      read_pbrt(folder,
                "Texture \"mask\" \"float\" \"checkerboard\"\n"
                "MakeNamedMaterial \"red\" \"string type\" \"diffuse\" \"rgb reflectance\" [ .6 .1 .1 ]\n"
                "MakeNamedMaterial \"gold\" \"string type\" \"conductor\" \"spectrum eta\" \"metal-Au-eta\" "
                "\"spectrum k\" "
                "\"metal-Au-k\"\n"
                "MakeNamedMaterial \"both\" \"string type\" \"mix\" \"string materials\" [ \"red\" \"gold\" "
                "] \"float amount\" "
                ".2\n"
                "NamedMaterial \"both\" Shape \"sphere\"\n"
                "Material \"mix\" \"string materials\" [ \"gold\" \"both\" ] \"texture amount\" \"mask\" "
                "Shape \"sphere\"\n");
  const Material& both = material_of(file, 0);
  EXPECT_EQ(both.name, "both");
  EXPECT_FLOAT_EQ(std::get<Mix>(both.lobe).amount, 0.2f);
  EXPECT_EQ(part_of(file, both, 0).name, "red");
  EXPECT_TRUE(std::holds_alternative<Lambert>(part_of(file, both, 0).lobe));
  EXPECT_EQ(std::get<Conductor>(part_of(file, both, 1).lobe).metal, Metal::Au);
  const Material& masked = material_of(file, 1);
  ASSERT_EQ(masked.maps.size(), 1u);
  EXPECT_TRUE(std::holds_alternative<Conductor>(part_of(file, masked, 0).lobe));
  EXPECT_TRUE(std::holds_alternative<Mix>(part_of(file, masked, 1).lobe));
}

TEST(MixedMaterials, OfPbrtWithWhatLightDoesNotSeeAreThereInPart) {
  const SceneFolder folder;
  const std::string materials =
      "MakeNamedMaterial \"red\" \"string type\" \"diffuse\"\n"
      "MakeNamedMaterial \"air\" \"string type\" \"interface\"\n";
  const SceneFile file = read_pbrt(
      folder,
      materials +
          "Material \"mix\" \"string materials\" [ \"red\" \"air\" ] \"float amount\" .2 Shape \"sphere\"\n"
          "Material \"mix\" \"string materials\" [ \"air\" \"red\" ] \"float amount\" .2 Shape \"sphere\"\n");
  EXPECT_TRUE(std::holds_alternative<Lambert>(material_of(file, 0).lobe));
  EXPECT_FLOAT_EQ(material_of(file, 0).alpha.value, 0.8f);
  EXPECT_FLOAT_EQ(material_of(file, 1).alpha.value, 0.2f);
}

TEST(MixedMaterials, OfPbrtTellWhatIsWrongWithThem) {
  const SceneFolder folder;
  const auto errors_of = [&](const std::string& world) {
    return errors(folder, "scene.pbrt", "WorldBegin\n" + world + "Shape \"sphere\"\n");
  };
  EXPECT_TRUE(contains(errors_of("Material \"mix\" \"string materials\" [ \"a\" \"b\" ]\n"),
                       "there is no material 'a'"));
  EXPECT_TRUE(contains(errors_of("Material \"mix\" \"string materials\" [ \"a\" ]\n"), "two names"));
  EXPECT_TRUE(contains(
      errors_of("MakeNamedMaterial \"m\" \"string type\" \"mix\" \"string materials\" [ \"m\" \"m\" ]\n"
                "NamedMaterial \"m\"\n"),
      "material 'm' is a mix of itself"));
}

TEST(MixedMaterials, OfMitsubaTakeTheSecondByTheirWeight) {
  const SceneFolder folder;
  const SceneFile file = read_mitsuba(folder,
                                      "<bsdf type='twosided'><bsdf type='blendbsdf'><float name='weight' "
                                      "value='.3'/><bsdf type='diffuse' id='d'/>"
                                      "<bsdf type='conductor' id='c'/></bsdf></bsdf>");
  const Material& blend = material_of(file, 0);
  EXPECT_FLOAT_EQ(std::get<Mix>(blend.lobe).amount, 0.3f);
  EXPECT_EQ(blend.back, BackSide::same);
  EXPECT_EQ(part_of(file, blend, 0).name, "d");
  EXPECT_TRUE(std::holds_alternative<Mirror>(part_of(file, blend, 1).lobe));
  EXPECT_EQ(part_of(file, blend, 0).back, BackSide::same) << "the mix has that";
}

TEST(MixedMaterials, OfMitsubaWithATexturedNullAreThereInPart) {
  const SceneFolder folder;
  const SceneFile file = read_mitsuba(
      folder,
      "<bsdf type='blendbsdf'><texture name='weight' type='checkerboard'><float name='color0' value='.1'/>"
      "<float name='color1' value='.9'/></texture><bsdf type='diffuse'/><bsdf type='null'/></bsdf>");
  const Material& leaf = material_of(file, 0);
  EXPECT_TRUE(std::holds_alternative<Lambert>(leaf.lobe));
  EXPECT_EQ(leaf.back, BackSide::absorbing);
  ASSERT_FALSE(leaf.alpha.is_constant());
  const Texture& alpha = file.scene.textures.at(index_of(leaf.alpha.map));
  EXPECT_NEAR(alpha.number({0.1f, 0.1f}) + alpha.number({0.6f, 0.1f}), 1, 1e-6);
}

TEST(MixedMaterials, OfMitsubaTellWhatIsWrongWithThem) {
  const SceneFolder folder;
  const auto errors_of = [&](const std::string& bsdf) {
    return errors(folder, "scene.xml",
                  "<scene version='3.0.0'><shape type='sphere'>" + bsdf + "</shape></scene>");
  };
  EXPECT_TRUE(contains(errors_of("<bsdf type='blendbsdf'><bsdf type='diffuse'/></bsdf>"), "two BSDFs"));
  EXPECT_TRUE(contains(errors_of("<bsdf type='blendbsdf' id='x'><bsdf type='diffuse'/><ref id='x'/></bsdf>"),
                       "BSDF 'x' has itself in it"));
  EXPECT_TRUE(contains(errors_of("<bsdf type='blendbsdf'><bsdf type='diffuse'/><bsdf type='twosided'><bsdf "
                                 "type='diffuse'/></bsdf></bsdf>"),
                       "differ in their back sides"));
}

}  // namespace
}  // namespace umbral
