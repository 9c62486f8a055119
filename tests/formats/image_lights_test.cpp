// Lights whose images cover all directions: which texel shines which way, in each format.
#include "scene_folder.h"

namespace umbral {
namespace {

using test::contains;
using test::SceneFolder;

// 3 × 3 pixels, linear where full or black; `rows` from the top.
std::string ppm(const std::string& size, const std::string& rows) { return "P3 " + size + " 255\n" + rows; }

// Red in the middle, green in the middle of the right edge, blue in that of the bottom edge; black elsewhere.
const std::string three_marks =
    ppm("3 3", "0 0 0  0 0 0  0 0 0\n0 0 0  255 0 0  0 255 0\n0 0 0  0 0 255  0 0 0\n");

// In the axes of pbrt's images the middles of those texels lie so: r = √(1 − z) = 2/3 for the outer two.
const double outer_z = 1 - 4.0 / 9, outer_x = std::sqrt(1 - sqr(outer_z));
const Vec3d middle{0, 0, 1}, right_edge{outer_x, 0, outer_z}, bottom_edge{0, outer_x, outer_z};

// "Rotate 40 about (1, 2, 3), then mirror x", and the map itself.
constexpr const char* turned_text = "Rotate 40 1 2 3\nScale -2 2 2\n";
const Affine turned = rotation(glm::normalize(Vec3d(1, 2, 3)), glm::radians(40.0)) * scaling({-1, 1, 1});

void expect_color(const Spectrum& a, const Spectrum& b, float tolerance = 1e-4f) {
  for (int c = 0; c < 3; ++c) EXPECT_NEAR(a[c], b[c], tolerance) << c;
}

std::string pbrt(const std::string& lights) { return "WorldBegin\n" + lights + "\nShape \"sphere\"\n"; }

TEST(PbrtImageLight, InfiniteImagesAreTurnedAsTheirLight) {
  const SceneFolder folder;
  folder.write("sky.ppm", three_marks);
  folder.write("scene.pbrt",
               pbrt(std::string("AttributeBegin ") + turned_text +
                    "LightSource \"infinite\" \"string filename\" \"sky.ppm\" \"float scale\" 3 "
                    "AttributeEnd"));
  const SceneFile file = folder.read("scene.pbrt");
  ASSERT_TRUE(file.scene.environment);
  const EnvironmentLight& sky = *file.scene.environment;
  expect_color(sky.emitted(Vec3(turned.vector(middle))), rgb(3, 0, 0));
  expect_color(sky.emitted(Vec3(turned.vector(right_edge))), rgb(0, 3, 0));
  expect_color(sky.emitted(Vec3(turned.vector(bottom_edge))), rgb(0, 0, 3));
}

// pbrt counts half of the solid angle: the mean of L cos over the upper half, 1/2, times π, not 2π.
TEST(PbrtImageLight, IlluminanceIsThatOfTheUpperHalf) {
  const SceneFolder folder;
  std::string white;
  for (int i = 0; i < 32 * 32; ++i) white += "255 255 255 ";
  folder.write("sky.ppm", ppm("32 32", white));
  folder.write("scene.pbrt",
               pbrt("LightSource \"infinite\" \"string filename\" \"sky.ppm\" \"float illuminance\" 7"));
  EXPECT_NEAR(folder.read("scene.pbrt").scene.environment->radiance.g, 7 / (pi_d / 2), 0.02);
}

TEST(PbrtImageLight, GoniometricImagesHaveYUp) {
  const SceneFolder folder;
  folder.write("lamp.ppm", three_marks);
  folder.write("scene.pbrt",
               pbrt(std::string("Translate 4 5 6\n") + turned_text +
                    "LightSource \"goniometric\" \"string filename\" \"lamp.ppm\" \"rgb I\" [ 3 6 9 ]"));
  const SceneFile file = folder.read("scene.pbrt");
  const auto& lamp = std::get<GoniometricLight>(file.scene.lights.at(0));
  EXPECT_EQ(lamp.position, Vec3(4, 5, 6));
  // The image is grey, the mean of its channels: 1/3 at each mark.
  const auto towards = [&](const Vec3d& d) { return Vec3(turned.vector({d.x, d.z, d.y})); };
  for (const Vec3d& mark : {middle, right_edge, bottom_edge})
    expect_color(lamp.intensity_towards(towards(mark)), rgb(1, 2, 3));
  expect_color(lamp.intensity_towards(towards({0, 0, -1})), black);
}

TEST(PbrtImageLight, GoniometricPowerIsThatOfTheMeanTexel) {
  const SceneFolder folder;
  folder.write("lamp.ppm", three_marks);
  folder.write("scene.pbrt",
               pbrt("LightSource \"goniometric\" \"string filename\" \"lamp.ppm\" \"float power\" 10"));
  const auto lamp = std::get<GoniometricLight>(folder.read("scene.pbrt").scene.lights.at(0));
  // Three texels of nine hold 1/3.
  EXPECT_NEAR(lamp.intensity.g, 10 / (4 * pi_d / 9), 1e-4);
  EXPECT_NEAR(lamp.power(), 10, 1e-4);
}

TEST(PbrtImageLight, MistakesAreToldWithTheirPlace) {
  const SceneFolder folder;
  folder.write("flat.ppm", ppm("2 1", "255 255 255 0 0 0"));
  folder.write("black.ppm", ppm("1 1", "0 0 0"));
  folder.write("white.ppm", ppm("1 1", "255 255 255"));
  const auto errors = [&](const std::string& light) {
    folder.write("scene.pbrt", pbrt(light));
    return folder.errors("scene.pbrt");
  };
  EXPECT_EQ(
      errors("LightSource \"infinite\" \"string filename\" \"flat.ppm\""),
      "scene.pbrt:2:25: error: 'flat.ppm' is 2 × 1 pixels: images of infinite and goniometric lights of "
      "pbrt-v4 are square, in equal-area octahedral layout\n    2 | LightSource \"infinite\" \"string "
      "filename\" \"flat.ppm\"\n"
      "      |                         ^");
  EXPECT_TRUE(contains(errors("LightSource \"infinite\" \"string filename\" \"black.ppm\""),
                       "the image is black: no light"));
  EXPECT_TRUE(contains(errors("LightSource \"goniometric\" \"string filename\" \"black.ppm\""),
                       "the image is black: no light"));
  EXPECT_TRUE(
      contains(errors("LightSource \"goniometric\""), "a goniometric light wants a \"string filename\""));
  EXPECT_TRUE(contains(errors("Scale 1 2 1 LightSource \"infinite\" \"string filename\" \"white.ppm\""),
                       "not supported: an image of a light that is stretched by its transform"));
  EXPECT_TRUE(
      contains(errors("LightSource \"infinite\" \"string filename\" \"white.ppm\" \"rgb L\" [ 1 1 1 ]"),
               "an infinite light has either 'L' or 'filename'"));
  EXPECT_TRUE(contains(errors("LightSource \"infinite\" \"string filename\" \"white.ppm\"\n"
                              "LightSource \"infinite\" \"string filename\" \"white.ppm\""),
                       "scene.pbrt:3:1: error: not supported: a second infinite light"));
}

constexpr const char* sky_4x2 =
    "P3 4 2 255\n255 0 0  0 255 0  0 0 255  255 255 255\n0 0 0  255 0 0  0 0 0  0 255 0\n";

SceneFile mitsuba(const SceneFolder& folder, const std::string& transform) {
  folder.write("sky.ppm", sky_4x2);
  folder.write("scene.xml",
               "<scene version='3.0.0'><emitter type='envmap'><string name='filename' value='sky.ppm'/>" +
                   transform + "</emitter><shape type='sphere'/></scene>");
  return folder.read("scene.xml");
}

// Mitsuba looks along +z into the middle of the image and finds −x to the right of it.
TEST(MitsubaEnvironment, TurnsAsItsTransformSays) {
  const SceneFolder folder;
  const EnvironmentLight level = *mitsuba(folder, "").scene.environment;
  // The middle of the third pixel of the upper row is an eighth of a turn to the right, half way up.
  const float s = std::sqrt(0.5f);
  expect_color(level.emitted({-s * s, s, s * s}), rgb(0, 0, 1));
  const EnvironmentLight tilted =
      *mitsuba(folder,
               "<transform name='to_world'><rotate x='1' angle='90'/><rotate y='1' angle='25'/></transform>")
           .scene.environment;
  const Affine way = rotation({0, 1, 0}, glm::radians(25.0)) * rotation({1, 0, 0}, glm::radians(90.0));
  for (const Vec3d& d : {Vec3d(-0.5, std::sqrt(0.5), 0.5), Vec3d(0.6, -0.8, 0), Vec3d(0, 0.28, -0.96)})
    expect_color(tilted.emitted(Vec3(way.vector(d))), level.emitted(Vec3(d)));
}

TEST(TomlEnvironment, TransformDoesAsRotation) {
  const SceneFolder folder;
  folder.write("sky.ppm", sky_4x2);
  const auto read = [&](const std::string& turn) {
    return *folder
                .read_toml(
                    "[[lights]]\ntype = \"environment\"\nfile = "
                    "\"sky.ppm\"\n" +
                    turn)
                .scene.environment;
  };
  const EnvironmentLight rotated = read("rotation = 30\n"),
                         transformed =
                             read("transform = [{ rotate = { axis = [0, 1, 0], degrees = 30 } }]\n"),
                         mirrored = read("transform = [{ scale = [-1, 1, 1] }]\n"), plain = read("");
  for (const Vec3& d : {Vec3(0.6f, 0, 0.8f), Vec3(-0.48f, 0.6f, 0.64f), Vec3(0.36f, -0.8f, -0.48f)}) {
    expect_color(transformed.emitted(d), rotated.emitted(d));
    expect_color(mirrored.emitted({-d.x, d.y, d.z}), plain.emitted(d));
  }
}

TEST(Spots, FadeAsInTheirFormats) {
  const SceneFolder folder;
  folder.write("scene.pbrt", pbrt("LightSource \"spot\""));
  EXPECT_EQ(std::get<SpotLight>(folder.read("scene.pbrt").scene.lights.at(0)).edge, SpotEdge::smooth_cosine);
  folder.write("scene.xml",
               "<scene version='3.0.0'><emitter type='spot'><float name='cutoff_angle' value='40'/></emitter>"
               "<shape type='sphere'/></scene>");
  const auto spot = std::get<SpotLight>(folder.read("scene.xml").scene.lights.at(0));
  EXPECT_EQ(spot.edge, SpotEdge::linear);
  EXPECT_EQ(spot.cone_angle, 40);
  EXPECT_EQ(spot.edge_angle, 10);
  EXPECT_EQ(spot.target - spot.position, Vec3(0, 0, 1));
}

}  // namespace
}  // namespace umbral
