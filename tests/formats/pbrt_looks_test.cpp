// Scenes of pbrt-v4: what their materials, textures and lights become.
#include "pbrt_kit.h"

namespace umbral {
namespace {

using test::expect_color;
using test::expect_near;
using test::lobe_of;
using test::read_pbrt;
using test::SceneFolder;
using test::square;

TEST(Pbrt, MaterialsBecomeLobes) {
  const SceneFolder folder;
  const SceneFile file = read_pbrt(
      folder,
      "MakeNamedMaterial \"skin\" \"string type\" \"coateddiffuse\" \"rgb reflectance\" [ .1 .2 .3 ]"
      " \"float roughness\" 0.04 \"float eta\" 1.4\n"
      "NamedMaterial \"skin\" Shape \"sphere\"\n"
      "Material \"conductor\" \"rgb eta\" [ 1 2 3 ] \"rgb k\" [ 4 5 6 ] \"float uroughness\" 0.09"
      " \"float vroughness\" 0.09 \"bool remaproughness\" false Shape \"sphere\"\n"
      "Material \"conductor\" \"spectrum eta\" \"metal-Au-eta\" \"spectrum k\" \"metal-Au-k\" Shape "
      "\"sphere\"\n"
      "Material \"conductor\" \"rgb reflectance\" [ .25 .25 .25 ] Shape \"sphere\"\n"
      "Material \"dielectric\" \"spectrum eta\" \"glass-BK7\" Shape \"sphere\"\n"
      "Material \"thindielectric\" \"float eta\" 1.3 Shape \"sphere\"\n"
      "Material \"diffusetransmission\" \"rgb transmittance\" [ .4 .2 .1 ] \"float scale\" 0.5 Shape "
      "\"sphere\"\n"
      "Material \"interface\" Shape \"sphere\"\n");
  ASSERT_EQ(file.scene.shapes.size(), 7u) << "an interface is nothing to see";
  const Plastic& plastic = std::get<Plastic>(lobe_of(file, 0));
  expect_color(plastic.reflectance, rgb(.1f, .2f, .3f));
  EXPECT_FLOAT_EQ(plastic.eta, 1.4f);
  EXPECT_NEAR(plastic.roughness, std::sqrt(std::sqrt(0.04)), 1e-6) << "alpha is the square root of 0.04";
  EXPECT_EQ(file.scene.materials[index_of(file.scene.shapes[0].material)].name, "skin");
  const Conductor& metal = std::get<Conductor>(lobe_of(file, 1));
  EXPECT_EQ(metal.eta, rgb(1, 2, 3));
  EXPECT_EQ(metal.k, rgb(4, 5, 6));
  EXPECT_NEAR(metal.roughness, 0.3, 1e-6) << "alpha is 0.09";
  EXPECT_EQ(std::get<Conductor>(lobe_of(file, 2)).metal, Metal::Au);
  expect_color(std::get<Conductor>(lobe_of(file, 3)).fresnel(1), grey(0.25f));
  EXPECT_NEAR(std::get<Dielectric>(lobe_of(file, 4)).eta, 1.5168, 1e-6);
  EXPECT_NEAR(std::get<ThinDielectric>(lobe_of(file, 5)).eta, 1.3, 1e-6);
  const auto& sheet = std::get<DiffuseTransmission>(lobe_of(file, 6));
  expect_color(sheet.reflectance, grey(0.125f));
  expect_color(sheet.transmittance, rgb(.2f, .1f, .05f));
}

TEST(Pbrt, MediaThatAbsorbFillGlass) {
  const SceneFolder folder;
  const SceneFile file =
      read_pbrt(folder,
                "MakeNamedMedium \"green\" \"string type\" \"homogeneous\" \"rgb sigma_a\" [ .5 .2 .4 ]"
                " \"rgb sigma_s\" [ 0 0 0 ] \"float scale\" 2\n"
                "AttributeBegin MediumInterface \"green\" \"\" Material \"dielectric\" Shape \"sphere\""
                " AttributeEnd Material \"dielectric\" Shape \"sphere\"");
  const Dielectric& filled = std::get<Dielectric>(lobe_of(file, 0));
  const Absorption absorption = Absorption::of_color(filled.attenuation_color, filled.attenuation_distance);
  expect_color(absorption.sigma, rgb(1, .4f, .8f));
  EXPECT_EQ(std::get<Dielectric>(lobe_of(file, 1)).attenuation_distance, infinity);
}

TEST(Pbrt, TexturesAndOpacity) {
  const SceneFolder folder;
  folder.write("leaf.tga", test::tga(2, 2, 255, 255, 255, 255));
  const SceneFile file = read_pbrt(
      folder,
      "Texture \"squares\" \"spectrum\" \"checkerboard\" \"rgb tex1\" [ .1 .1 .1 ] \"float uscale\" 4 "
      "\"float vdelta\" .5\n"
      "Texture \"leaf\" \"spectrum\" \"imagemap\" \"string filename\" \"leaf.tga\" \"string wrap\" \"clamp\" "
      "\"bool invert\" true\n"
      "Texture \"half\" \"float\" \"constant\" \"float value\" .5\n"
      "Texture \"dim\" \"spectrum\" \"scale\" \"texture tex\" \"leaf\" \"texture scale\" \"half\"\n"
      "Material \"diffuse\" \"texture reflectance\" \"squares\" Shape \"sphere\"\n"
      "Material \"diffuse\" \"texture reflectance\" \"dim\"\n"
      "Shape \"sphere\" \"float alpha\" .25 Shape \"sphere\" \"texture alpha\" \"half\" Shape \"sphere\"\n");
  const auto material = [&](std::size_t shape) -> const Material& {
    return file.scene.materials.at(index_of(file.scene.shapes.at(shape).material));
  };
  const auto texture = [&](std::size_t shape) -> const Texture& {
    return file.scene.textures.at(index_of(material(shape).maps.at(0).texture));
  };
  const auto& checker = std::get<CheckerTexture>(texture(0).kind);
  EXPECT_EQ(checker.even, grey(0.1f));
  EXPECT_EQ(checker.odd, black);
  EXPECT_EQ(checker.uv_scale, Vec2(4, 1));
  EXPECT_EQ(checker.uv_offset, Vec2(0, 0.5f));
  const auto& image = std::get<ImageTexture>(texture(1).kind);
  EXPECT_EQ(image.wrap, Wrap::clamp);
  EXPECT_FLOAT_EQ(image.factor, -0.5f);
  EXPECT_FLOAT_EQ(image.bias, 0.5f);
  EXPECT_FLOAT_EQ(material(1).alpha.value, 0.25f);
  EXPECT_FLOAT_EQ(material(2).alpha.value, 0.5f);
  EXPECT_TRUE(material(3).is_opaque());
}

TEST(Pbrt, TexturesOfTexturesBumpsAndNormals) {
  const SceneFolder folder;
  folder.write("n.tga", test::tga(2, 2, 128, 128, 255, 255));
  const SceneFile file =
      read_pbrt(folder,
                "Texture \"a\" \"spectrum\" \"checkerboard\"\nTexture \"b\" \"float\" \"checkerboard\"\n"
                "Texture \"ab\" \"spectrum\" \"scale\" \"texture tex\" \"a\" \"texture scale\" \"b\"\n"
                "Texture \"mix\" \"spectrum\" \"mix\" \"texture tex1\" \"ab\" \"rgb tex2\" [ 0 0 1 ] \"float "
                "amount\" .25\n"
                "Material \"diffuse\" \"texture reflectance\" \"mix\" \"texture displacement\" \"b\""
                " \"string normalmap\" \"n.tga\"\nShape \"sphere\"\n");
  const Material& material = file.scene.materials.at(index_of(file.scene.shapes.at(0).material));
  const auto& mix = std::get<MixTexture>(file.scene.textures.at(index_of(material.maps.at(0).texture)).kind);
  EXPECT_EQ(mix.b.value, rgb(0, 0, 1));
  EXPECT_EQ(mix.amount.value, 0.25f);
  EXPECT_TRUE(std::holds_alternative<ScaleTexture>(file.scene.textures.at(index_of(mix.a.map)).kind));
  EXPECT_TRUE(material.has_bump_map());
  EXPECT_TRUE(material.has_normal_map());
}

TEST(Pbrt, LightsInTheirUnits) {
  const SceneFolder folder;
  const SceneFile file = read_pbrt(
      folder,
      "Translate 0 0 1\n"
      "LightSource \"point\" \"rgb I\" [ 1 2 3 ] \"float scale\" 2 \"point3 from\" [ 4 5 6 ]\n"
      "LightSource \"point\" \"blackbody I\" 3000 \"float power\" 100\n"
      "LightSource \"spot\" \"point3 to\" [ 0 0 -1 ] \"float coneangle\" 20 \"float power\" 10\n"
      "LightSource \"distant\" \"point3 from\" [ 0 3 0 ] \"point3 to\" [ 0 0 0 ] \"float illuminance\" 7\n"
      "LightSource \"infinite\" \"rgb L\" [ .1 .2 .3 ] \"float scale\" 2\n"
      "LightSource \"infinite\" \"rgb L\" [ .1 .1 .1 ]\n" +
          std::string(square),
      "Film \"rgb\" \"float iso\" 300\n");
  const auto& point = std::get<PointLight>(file.scene.lights.at(0));
  expect_near(point.position, {4, 5, 7});
  expect_color(point.intensity, rgb(6, 12, 18));
  const auto& warm = std::get<PointLight>(file.scene.lights.at(1));
  EXPECT_NEAR(luminance(warm.intensity), 3 * 100 / (4 * pi_d), 1e-4);
  EXPECT_GT(warm.intensity.r, 2 * warm.intensity.b);
  const auto& spot = std::get<SpotLight>(file.scene.lights.at(2));
  EXPECT_FLOAT_EQ(spot.cone_angle, 20);
  const double full = std::cos(glm::radians(15.0)), end = std::cos(glm::radians(20.0));
  EXPECT_NEAR(spot.intensity.g, 3 * 10 / (2 * pi_d * (1 - full + (full - end) / 2)), 1e-3);
  const auto& sun = std::get<DistantLight>(file.scene.lights.at(3));
  expect_near(sun.direction, {0, -1, 0});
  expect_color(sun.irradiance, grey(21));
  ASSERT_TRUE(file.scene.environment);
  expect_color(file.scene.environment->radiance, rgb(0.9f, 1.5f, 2.1f));
}

TEST(Pbrt, AreaLightsShineByRadianceOrPower) {
  const SceneFolder folder;
  const SceneFile file = read_pbrt(folder,
                                   "AttributeBegin AreaLightSource \"diffuse\" \"rgb L\" [ 17 12 4 ] "
                                   "\"bool twosided\" true\n" +
                                       std::string(square) +
                                       "AttributeEnd\nAreaLightSource \"diffuse\" \"float power\" 50\n"
                                       "Scale 2 2 2 Shape \"sphere\"\n" +
                                       square);
  EXPECT_EQ(file.scene.shapes.at(0).emission.value, rgb(17, 12, 4));
  EXPECT_TRUE(file.scene.shapes[0].two_sided);
  EXPECT_NEAR(file.scene.shapes.at(1).emission.value.g, 50 / (pi_d * 16 * pi_d), 1e-5);
  // Each triangle of 8 square units is a light of its own.
  ASSERT_EQ(file.scene.shapes.size(), 4u);
  EXPECT_NEAR(file.scene.shapes[2].emission.value.g, 50 / (pi_d * 8), 1e-5);
}

}  // namespace
}  // namespace umbral
