// `umbral convert`: what was converted renders as what it was made from.
#include <filesystem>

#include <gtest/gtest.h>

#include "formats/gltf_kit.h"
#include "image/exr.h"
#include "support/command.h"

namespace umbral {
namespace {

using test::SceneFolder;

struct Convert : testing::Test {
  SceneFolder folder;

  test::CommandResult run(const std::string& arguments) const {
    return test::run_command("cd '" + folder.path("").string() + "' && " UMBRAL_PROGRAM " " + arguments);
  }

  std::vector<std::vector<float>> rendered(const std::string& scene) const {
    const auto outcome = run("render '" + scene + "' --quiet --spp 4 --size 40x30 -o out.exr");
    EXPECT_EQ(outcome.exit_code, 0) << outcome.text;
    std::vector<std::vector<float>> channels;
    for (const char* name : {"R", "G", "B"})
      channels.push_back(read_exr(folder.path("out.exr").string()).find(name)->pixels);
    return channels;
  }

  // Both as close as float arithmetic allows; returns the text of the converted scene.
  std::string expect_same(const std::string& scene, const std::string& written = "made/scene.toml") {
    const auto outcome = run("convert '" + scene + "' " + written);
    EXPECT_EQ(outcome.exit_code, 0) << outcome.text;
    const auto before = rendered(scene), after = rendered(written);
    double sum = 0;
    for (std::size_t c = 0; c < 3; ++c)
      for (std::size_t i = 0; i < before[c].size(); ++i) {
        EXPECT_EQ(before[c][i], after[c][i]) << "channel " << c << ", pixel " << i;
        sum += static_cast<double>(before[c][i]);
      }
    EXPECT_GT(sum, 1);
    std::ifstream in(folder.path(written));
    return {std::istreambuf_iterator<char>(in), {}};
  }

  Convert() { std::filesystem::create_directories(folder.path("made")); }
};

TEST_F(Convert, GltfWithInstancesTexturesLightsAndCamera) {
  test::GltfSquare square(
      R"(, {"buffer": 0, "byteOffset": 140, "byteLength": 16})",
      R"(, {"bufferView": 4, "componentType": 5121, "normalized": true, "count": 4, "type": "VEC4"})");
  square.bytes.add<std::uint8_t>({255, 0, 0, 255, 0, 255, 0, 255, 0, 0, 255, 255, 255, 255, 255, 255});
  folder.write("t.tga", test::tga(4, 4, 210, 120, 30, 40));
  std::string text = square.file(
      R"({"mesh": 0, "name": "a \"quoted\" one"}, {"mesh": 0, "translation": [0.5, 0, 0.7], "rotation": [0, 0.38, 0, 0.92]},
         {"camera": 0, "translation": [0, 0, 5]}, {"extensions": {"KHR_lights_punctual": {"light": 0}}, "translation": [2, 1, 4]})",
      4,
      R"(, "cameras": [{"type": "perspective", "perspective": {"yfov": 0.7, "znear": 0.1}}],
         "materials": [{"name": "paint", "pbrMetallicRoughness": {"baseColorFactor": [0.5, 0.6, 0.7, 1], "metallicFactor": 0.5,
           "baseColorTexture": {"index": 0, "extensions": {"KHR_texture_transform": {"scale": [2, 3], "rotation": 0.3}}}},
           "normalTexture": {"index": 0, "scale": 0.3}, "alphaMode": "MASK", "doubleSided": true, "emissiveFactor": [0.1, 0, 0],
           "extensions": {"KHR_materials_clearcoat": {"clearcoatFactor": 0.5,
             "clearcoatNormalTexture": {"index": 0, "scale": 0.6}}}}],
         "textures": [{"source": 0}], "images": [{"uri": "t.tga"}],
         "extensionsUsed": ["KHR_lights_punctual", "KHR_texture_transform", "KHR_materials_clearcoat"],
         "extensions": {"KHR_lights_punctual": {"lights": [{"type": "point", "intensity": 30}]}})",
      R"(, "material": 0)");
  text.replace(text.find(R"("TEXCOORD_0": 2)"), 15, R"("TEXCOORD_0": 2, "COLOR_0": 4)");
  folder.write("a.gltf", text);
  const std::string made = expect_same("a.gltf");
  EXPECT_TRUE(test::contains(made, "[materials.\"paint\"]\ntype = \"principled\"\n")) << made;
  EXPECT_TRUE(test::contains(made, "../t.tga")) << made;  // referred to where it is
  EXPECT_TRUE(test::contains(made, "[[instances]]")) << made;
  EXPECT_TRUE(test::contains(made, "\nclearcoat_normal_scale = 0.6")) << made;
}

TEST_F(Convert, ObjWithoutLight) {
  folder.write("m.mtl", "newmtl red\nKd 0.7 0.1 0.1\nKs 0.2 0.2 0.2\nNs 50\n");
  folder.write("m.obj", "mtllib m.mtl\nusemtl red\nv 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0.3\nf 1 2 3\nf 1 3 4\n");
  const std::string made = expect_same("m.obj");
  EXPECT_TRUE(test::contains(made, "scene-files/image-0.exr")) << made;  // the sky that it is shown under
}

TEST_F(Convert, TomlWithAnalyticShapesNestedTexturesAndSettings) {
  folder.write("s.toml", R"([camera]
position = [0, 1, 4]
look_at = [0, 0.5, 0]
[integrator]
type = "path"
[integrator.path]
max_depth = 3
[textures.squares]
type = "checker"
uv_scale = [3, 3]
[textures.tinted]
type = "scale"
texture = "squares"
scale = [0.9, 0.8, 0.2]
[materials.floor]
type = "matte"
reflectance = "tinted"
[[shapes]]
type = "sphere"
emission = [2, 1, 1]
transform = [{ scale = [1, 0.5, 1] }, { translate = [0, 1, 0] }]
[[shapes]]
type = "rectangle"
material = "floor"
transform = [{ scale = 3 }, { rotate = { axis = [1, 0, 0], degrees = -70 } }]
)");
  const std::string made = expect_same("s.toml");
  EXPECT_TRUE(test::contains(made, "max_depth = 3")) << made;
}

TEST_F(Convert, ImagesOfLightsStayTurnedAsTheyWere) {
  folder.write("sky.ppm",
               "P3 4 2 255\n255 0 0  0 255 0  0 0 255  255 255 255\n9 9 9  255 0 0  90 0 80  0 255 0\n");
  folder.write(
      "s.xml",
      "<scene version='3.0.0'><emitter type='envmap'><string name='filename' value='sky.ppm'/><transform "
      "name='to_world'><rotate x='1' y='2' z='.3' angle='73'/></transform></emitter>"
      "<shape type='sphere'/></scene>");
  EXPECT_TRUE(test::contains(expect_same("s.xml"), "transform = [{ matrix = "));
  folder.write("lamp.ppm", "P3 2 2 255\n255 255 255  90 90 90\n30 30 30  255 0 0\n");
  folder.write(
      "s.pbrt",
      "LookAt 0 0 4 0 0 0 0 1 0\nCamera \"perspective\"\nWorldBegin\nRotate 40 1 2 3\nLightSource "
      "\"infinite\" \"string filename\" \"lamp.ppm\"\nTranslate 1 2 3\nScale -1 1 1\nLightSource "
      "\"goniometric\" \"string filename\" \"lamp.ppm\" \"float scale\" 20\nIdentity Shape \"sphere\"\n");
  const std::string made = expect_same("s.pbrt");
  EXPECT_TRUE(test::contains(made, "mapping = \"equal_area\"")) << made;
  EXPECT_TRUE(test::contains(made, "../lamp.ppm")) << made;
}

TEST_F(Convert, ThrownImagesAndTexturesThroughSpace) {
  folder.write("lamp.ppm", "P3 2 2 255\n255 255 255  90 90 90\n30 30 30  255 0 0\n");
  folder.write(
      "s.pbrt",
      "LookAt 0 0 4 0 0 0 0 1 0\nCamera \"perspective\"\nWorldBegin\nAttributeBegin Rotate 40 1 2 3\n"
      "Texture \"t\" \"spectrum\" \"imagemap\" \"string filename\" \"lamp.ppm\" \"string mapping\" "
      "\"spherical\"\nTranslate 1 0 -4\nRotate 20 0 1 0\nScale -1 1 1\n"
      "LightSource \"projection\" \"string filename\" \"lamp.ppm\" \"float scale\" 90\nAttributeEnd\n"
      "LightSource \"infinite\" Material \"diffuse\" \"texture reflectance\" \"t\" Shape \"sphere\"\n");
  const std::string made = expect_same("s.pbrt");
  for (const char* line : {"image_angle = 90", "type = \"projected\"", "projection = \"spherical\""})
    EXPECT_TRUE(test::contains(made, line)) << made;
}

constexpr const char* tiled_scene = R"([materials.m]
type = "matte"
reflectance = { type = "image", file = "t.<UDIM>.tga", uv_scale = [2, 2], uv_offset = [0, -0.5] }
[[shapes]]
type = "rectangle"
material = "m"
[[lights]]
type = "environment"
)";

TEST_F(Convert, TilesAreReferredToTogether) {
  folder.write("t.1001.tga", test::tga(2, 2, 255, 0, 0, 255));
  folder.write("t.1002.tga", test::tga(2, 2, 0, 255, 0, 255));
  folder.write("t.1012.tga", test::tga(2, 2, 0, 0, 255, 255));
  folder.write("s.toml", tiled_scene);
  const std::string made = expect_same("s.toml");
  EXPECT_TRUE(test::contains(made, "file = \"../t.<UDIM>.tga\"")) << made;
}

TEST_F(Convert, ImagesAreFoundFromTheWorkingDirectory) {
  folder.write("t.1001.tga", test::tga(2, 2, 255, 0, 0, 255));
  folder.write("s.toml", tiled_scene);
  for (const std::string& scene : {std::string("s.toml"), folder.path("s.toml").string()}) {
    const std::string made = expect_same(scene, "beside.toml");
    EXPECT_TRUE(test::contains(made, "file = \"t.<UDIM>.tga\"")) << made;
  }
}

TEST_F(Convert, RefusesWhatWouldLoseAScene) {
  folder.write("s.toml", "[[shapes]]\ntype = \"sphere\"\nemission = 1\n");
  EXPECT_NE(run("convert s.toml s.toml").exit_code, 0);
  EXPECT_NE(run("convert s.toml s.txt").exit_code, 0);
  EXPECT_NE(run("convert s.toml nowhere/s.toml").exit_code, 0);
}

}  // namespace
}  // namespace umbral
