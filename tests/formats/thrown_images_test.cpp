// Images that point lights throw in pbrt and Mitsuba: which texel shines which way, and how strongly.
#include "scene_folder.h"

namespace umbral {
namespace {

using test::contains;
using test::SceneFolder;

// 4 × 2 texels: red, green, blue, white above four greys that are dark.
constexpr const char* slide =
    "P3 4 2 255\n255 0 0  0 255 0  0 0 255  255 255 255\n0 0 0  0 0 0  0 0 0  0 0 0\n";

// What the only light sends along `direction`: its intensity there.
Spectrum sent(const SceneFile& file, const Vec3d& direction) {
  const auto& light = std::get<SpotLight>(file.scene.lights.at(0));
  const auto sample = light.sample(Vec3(Vec3d(light.position) + direction));
  return sample ? sample->radiance * sqr(sample->distance) : black;
}

void expect_color(const Spectrum& a, const Spectrum& b, float tolerance = 2e-4f) {
  for (int c = 0; c < 3; ++c) EXPECT_NEAR(a[c], b[c], tolerance) << c;
}

SceneFile read_pbrt(const SceneFolder& folder, const std::string& transform, const std::string& parameters) {
  folder.write("slide.ppm", slide);
  folder.write("scene.pbrt", "WorldBegin\n" + transform +
                                 "\nLightSource \"projection\" \"string filename\" \"slide.ppm\" " +
                                 parameters + "\nIdentity Shape \"sphere\"\n");
  return folder.read("scene.pbrt");
}

// pbrt's light looks along +z; columns grow towards +x, and rows, downwards, towards −y. fov is that of the shorter side.
TEST(PbrtProjection, ThrowsItsImageAlongZWithYUp) {
  const SceneFolder folder;
  const double half = std::tan(glm::radians(20.0));
  const Affine turned = translation({4, 5, 6}) * rotation(glm::normalize(Vec3d(1, 2, 3)), glm::radians(40.0));
  for (const double side : {1.0, -1.0}) {
    const Affine to_world = turned * scaling({2 * side, 2, 2});
    const SceneFile file =
        read_pbrt(folder, "Translate 4 5 6 Rotate 40 1 2 3 Scale " + std::to_string(2 * side) + " 2 2",
                  "\"float fov\" 40 \"float scale\" 3");
    EXPECT_EQ(std::get<SpotLight>(file.scene.lights.at(0)).position, Vec3(4, 5, 6));
    const Spectrum row[] = {rgb(3, 0, 0), rgb(0, 3, 0), rgb(0, 0, 3), rgb(3, 3, 3)};
    for (int x = 0; x < 4; ++x) {
      const double right = half * (x + 0.5 - 2);
      expect_color(sent(file, to_world.vector({right, 0.5 * half, 1})), row[x]);
      expect_color(sent(file, to_world.vector({right, -0.5 * half, 1})), black);
    }
    expect_color(sent(file, to_world.vector({1.999 * half, 0.999 * half, 1})), row[3]);
    expect_color(sent(file, to_world.vector({2.001 * half, 0.5 * half, 1})), black);
    expect_color(sent(file, to_world.vector({1.5 * half, 1.001 * half, 1})), black);
    expect_color(sent(file, to_world.vector({-1.5 * half, -0.5 * half, -1})), black);
  }
}

TEST(PbrtProjection, HasThePowerThatItIsTold) {
  const SceneFolder folder;
  const SceneFile file = read_pbrt(folder, "", "\"float power\" 10");
  EXPECT_NEAR(std::get<SpotLight>(file.scene.lights.at(0)).power(), 10, 1e-4);
}

TEST(PbrtProjection, MistakesAreTold) {
  const SceneFolder folder;
  folder.write("black.ppm", "P3 1 1 255\n0 0 0\n");
  folder.write("white.ppm", "P3 1 1 255\n255 255 255\n");
  const auto errors = [&](const std::string& light) {
    folder.write("scene.pbrt", "WorldBegin\n" + light + "\nShape \"sphere\"\n");
    return folder.errors("scene.pbrt");
  };
  EXPECT_TRUE(contains(errors("LightSource \"projection\""),
                       "2:1: error: a projection light wants a \"string filename\""));
  EXPECT_TRUE(contains(errors("LightSource \"projection\" \"string filename\" \"black.ppm\""),
                       "the image is black: no light"));
  EXPECT_TRUE(contains(errors("LightSource \"projection\" \"string filename\" \"no.ppm\""), "no.ppm"));
  EXPECT_TRUE(
      contains(errors("LightSource \"projection\" \"string filename\" \"white.ppm\" \"float fov\" 180"),
               "'fov' must be above 0 and below 180 degrees"));
  EXPECT_TRUE(
      contains(errors("LightSource \"projection\" \"string filename\" \"white.ppm\" \"rgb I\" [ 1 1 1 ]"),
               "light 'projection' has no parameter 'I'"));
  EXPECT_TRUE(contains(errors("Scale 1 2 1 LightSource \"projection\" \"string filename\" \"white.ppm\""),
                       "not supported: an image of a light that is stretched by its transform"));
}

SceneFile read_mitsuba(const SceneFolder& folder, const std::string& texture,
                       const std::string& transform = "") {
  folder.write("slide.ppm", slide);
  folder.write(
      "scene.xml",
      "<scene version='3.0.0'><emitter type='spot'><rgb name='intensity' value='2, 2, 2'/><float "
      "name='cutoff_angle' value='40'/><float name='beam_width' value='40'/><texture name='texture' " +
          texture + "</texture>" + transform + "</emitter><shape type='sphere'/></scene>");
  return folder.read("scene.xml");
}

const std::string bitmap = "type='bitmap'><string name='filename' value='slide.ppm'/>";

// u = ½ + x / 2z tan α, and v with y; v runs down the image, which is as wide as high whatever its pixels.
TEST(MitsubaSpot, ThrowsItsTextureOverTheSquareAroundItsCone) {
  const SceneFolder folder;
  const double reach = std::tan(glm::radians(40.0));
  for (const char* side : {"1", "-1"}) {
    const SceneFile file =
        read_mitsuba(folder, bitmap,
                     std::string("<transform name='to_world'><scale x='") + side +
                         "'/><rotate x='1' y='2' z='3' angle='40'/><translate y='5'/></transform>");
    const Affine to_world =
        rotation(glm::normalize(Vec3d(1, 2, 3)), glm::radians(40.0)) * scaling({std::stod(side), 1, 1});
    const auto at = [&](double u, double v) {
      return sent(file, to_world.vector({(2 * u - 1) * reach, (2 * v - 1) * reach, 1}));
    };
    expect_color(at(0.375, 0.25), rgb(0, 2, 0));
    expect_color(at(0.625, 0.25), rgb(0, 0, 2));
    expect_color(at(0.375, 0.75), black);
    expect_color(at(0.875, 0.05), black);  // beyond the cone
  }
}

TEST(MitsubaSpot, TellsWhatItCannotThrow) {
  const SceneFolder folder;
  const auto errors = [&](const std::string& texture) {
    try {
      read_mitsuba(folder, texture);
    } catch (const SceneError& error) {
      return std::string(error.what());
    }
    return std::string("no error");
  };
  EXPECT_TRUE(
      contains(errors("type='checkerboard'>"), "not supported: a spot light that throws a 'checkerboard'"));
  EXPECT_TRUE(contains(errors(bitmap + "<transform name='to_uv'><scale value='2'/></transform>"),
                       "not supported: a transform of the image that a spot light throws"));
  EXPECT_TRUE(contains(errors(bitmap + "<float name='filename2' value='3'/>"), "filename2"));
  EXPECT_TRUE(
      contains(folder.warnings(read_mitsuba(folder, bitmap + "<string name='filter_type' value='nearest'/>")),
               "which are interpolated"));
}

}  // namespace
}  // namespace umbral
