// Photometric files: which way the numbers of LM-63 shine, symmetries, and files that are none.
#include "formats/ies.h"

#include <fmt/format.h>

#include "scene/lights/goniometric.h"
#include "scene_folder.h"

namespace umbral {
namespace {

using test::SceneFolder;

std::string file_of(const std::string& vertical, const std::string& horizontal, const std::string& candela,
                    int verticals, int horizontals, const std::string& tilt = "TILT=NONE") {
  return "IESNA:LM-63-2002\r\n[TEST] none # of 3\r\n" + tilt +
         fmt::format("\r\n1 1000 2.0 {} {} 1 2 0 0,0\r\n0.5 1.0 30\r\n{}\r\n{}\r\n{}\r\n", verticals,
                     horizontals, vertical, horizontal, candela);
}

// Candela towards these angles: `vertical` from straight down, `horizontal` counter-clockwise from −z, seen from above.
double candela(const TextureImage& image, double vertical, double horizontal) {
  GoniometricLight light;
  light.image = std::make_shared<TextureImage>(image);
  const double v = glm::radians(vertical), h = glm::radians(horizontal);
  return 179.0 * light
                     .intensity_towards(
                         Vec3(Vec3d(-std::sin(v) * std::sin(h), -std::cos(v), -std::sin(v) * std::cos(h))))
                     .g;
}

TEST(Ies, IsLinearBetweenItsAngles) {
  const TextureImage image = luminaire_image(file_of("0 60 90", "0", "100 40 0", 3, 1), "a.ies");
  EXPECT_EQ(image.width(), 1) << "the same all round";
  EXPECT_NEAR(candela(image, 0, 0), 100, 0.5) << "multiplier 2 times ballast factor 0.5";
  EXPECT_NEAR(candela(image, 30, 123), 70, 1e-2);
  EXPECT_NEAR(candela(image, 75, 10), 20, 1e-2);
  EXPECT_EQ(candela(image, 91, 0), 0) << "nothing beyond the angles of the file";
}

TEST(Ies, TurnsCounterClockwiseSeenFromAbove) {
  const TextureImage image =
      luminaire_image(file_of("0 180", "0 90 180 270", "0 0 90 90 180 180 270 270", 2, 4), "a");
  for (const double angle : {10.0, 45.0, 100.0, 260.0}) EXPECT_NEAR(candela(image, 80, angle), angle, 0.01);
  EXPECT_NEAR(candela(image, 80, 315), 135, 0.01) << "between the last angle and the first";
}

TEST(Ies, UnfoldsItsSymmetries) {
  const std::string rising = "0 0 30 30 60 60 90 90";
  const TextureImage quarter = luminaire_image(file_of("0 180", "0 30 60 90", rising, 2, 4), "a");
  const TextureImage half = luminaire_image(file_of("0 180", "0 60 120 180", rising, 2, 4), "a");
  const TextureImage across = luminaire_image(file_of("0 180", "90 150 210 270", rising, 2, 4), "a");
  for (const double angle : {20.0, 80.0}) {
    for (const double same : {angle, 180 - angle, 180 + angle, 360 - angle})
      EXPECT_NEAR(candela(quarter, 50, same), angle, 0.5);
    for (const double same : {angle, 360 - angle}) EXPECT_NEAR(candela(half, 50, same), angle / 2, 0.5);
    for (const double same : {90 + angle, 90 - angle}) EXPECT_NEAR(candela(across, 50, same), angle / 2, 0.5);
  }
}

TEST(Ies, SkipsTheTiltOfItsLamp) {
  const std::string tilt = "TILT=INCLUDE\r\n1\r\n2\r\n0 90\r\n1 0.8";
  EXPECT_NEAR(candela(luminaire_image(file_of("0 180", "0", "7 7", 2, 1, tilt), "a"), 20, 0), 7, 1e-4);
}

testing::AssertionResult says(const std::string& message, const std::string& part) {
  if (message.find(part) != std::string::npos) return testing::AssertionSuccess();
  return testing::AssertionFailure() << '"' << message << "\" lacks \"" << part << '"';
}

TEST(Ies, SaysWhatIsWrong) {
  const auto message = [](const std::string& text) -> std::string {
    try {
      luminaire_image(text, "lamp.ies");
    } catch (const SceneError& error) {
      return error.what();
    }
    return "none";
  };
  const std::string good = file_of("0 180", "0", "7 7", 2, 1);
  EXPECT_EQ(message(good), "none");
  EXPECT_TRUE(says(message("P6 1 1"), "no line TILT="));
  EXPECT_TRUE(says(message(good.substr(0, good.size() - 4)), "ends too early"));
  EXPECT_TRUE(says(message(file_of("0 180", "0", "7 -7", 2, 1)), "negative"));
  EXPECT_TRUE(says(message(file_of("0 0", "0", "7 7", 2, 1)), "do not ascend"));
  EXPECT_TRUE(says(message(file_of("0 180", "0", "7 x", 2, 1)), "lamp.ies:8: error: 'x' is not a number"));
  EXPECT_TRUE(says(message(file_of("0 180", "0", "7 7", 2, 1, "TILT=lamp.til")), "TILT"));
  std::string type_b = good;
  type_b.replace(type_b.find(" 1 2 0 0,0"), 2, " 2");
  EXPECT_TRUE(says(message(type_b), "type C"));
  EXPECT_TRUE(says(message(file_of("0 180", "0", "7 7", 0, 1)), "number of vertical angles"));
}

TEST(Ies, IsTheImageOfAGoniometricLight) {
  const SceneFolder folder;
  folder.write("lamp.ies", file_of("0 180", "0", "179 179", 2, 1));
  const SceneFile file = folder.read_toml(
      "[[shapes]]\ntype = \"sphere\"\nemission = 1\n[[lights]]\ntype = \"goniometric\"\nfile = "
      "\"lamp.ies\"\nintensity = 2\n");
  EXPECT_NEAR(std::get<GoniometricLight>(file.scene.lights.at(0)).power(), 8 * pi_d, 1e-2);
}

}  // namespace
}  // namespace umbral
