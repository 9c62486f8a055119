// Textures of pbrt that are laid through space: the texture coordinates of a place are those of pbrt's own formulas.
#include "scene_folder.h"
#include "support/random.h"

namespace umbral {
namespace {

using test::contains;
using test::SceneFolder;

// What follows in the file, and the same as a map.
constexpr const char* placed_text = "Translate 1 2 3\nRotate 40 1 2 3\nScale 2 -1 .5\n";
const Affine placed = translation({1, 2, 3}) * rotation(glm::normalize(Vec3d(1, 2, 3)), glm::radians(40.0)) *
                      scaling({2, -1, 0.5});

std::string scene_of(const std::string& texture) {
  return std::string("WorldBegin\nAttributeBegin\n") + placed_text + texture +
         "\nAttributeEnd\nMaterial \"diffuse\" \"texture reflectance\" \"t\"\nShape \"sphere\"\n";
}

// Where a place of the world lies in the texture of the first shape's material.
class Coordinates {
 public:
  explicit Coordinates(const std::string& mapping) {
    folder_.write("scene.pbrt", scene_of("Texture \"t\" \"spectrum\" \"checkerboard\" " + mapping));
    file_ = folder_.read("scene.pbrt");
  }
  glm::dvec2 operator()(const Vec3d& p) const {
    const Material& material = file_.scene.materials.at(index_of(file_.scene.shapes.at(0).material));
    TexturePoint point;
    point.p = Vec3(p);
    return glm::dvec2(file_.scene.textures.at(index_of(material.maps.at(0).texture)).placed(point));
  }

 private:
  SceneFolder folder_;
  SceneFile file_;
};

// `expected` takes a place in the texture's own space.
template <class Expected>
void expect_coordinates(const std::string& mapping, const Expected& expected) {
  const Coordinates coordinates(mapping);
  test::Random random(7);
  for (int i = 0; i < 200; ++i) {
    const Vec3d q = random.in_cube(3);
    const glm::dvec2 found = coordinates(placed.point(q)), wanted = expected(q);
    EXPECT_LT(glm::length(found - wanted), 2e-5) << q.x << ' ' << q.y << ' ' << q.z << ": " << found.x << ' '
                                                 << found.y << ", not " << wanted.x << ' ' << wanted.y;
  }
}

double azimuth(const Vec3d& q) { return std::atan2(q.y, q.x); }

TEST(PbrtMapping, Planar) {
  expect_coordinates(
      "\"string mapping\" \"planar\" \"vector3 v1\" [ 1 2 0 ] \"vector3 v2\" [ 0 .5 -1 ] \"float udelta\" "
      ".25 "
      "\"float vdelta\" -3",
      [](const Vec3d& q) {
        return glm::dvec2(0.25 + dot(q, {1, 2, 0}), -3 + dot(q, {0, 0.5, -1}));
      });
}

TEST(PbrtMapping, Cylindrical) {
  expect_coordinates("\"string mapping\" \"cylindrical\"",
                     [](const Vec3d& q) { return glm::dvec2((pi_d + azimuth(q)) / (2 * pi_d), q.z); });
}

TEST(PbrtMapping, Spherical) {
  expect_coordinates("\"string mapping\" \"spherical\"", [](const Vec3d& q) {
    const double phi = azimuth(q) < 0 ? azimuth(q) + 2 * pi_d : azimuth(q);
    return glm::dvec2(std::acos(q.z / glm::length(q)) / pi_d, phi / (2 * pi_d));
  });
}

TEST(PbrtMapping, ImagesAreLaidWithTheirOwnValues) {
  const SceneFolder folder;
  folder.write("t.tga", test::tga(2, 2, 255, 0, 0, 255));
  folder.write("scene.pbrt",
               scene_of("Texture \"t\" \"spectrum\" \"imagemap\" \"string filename\" \"t.tga\" \"string "
                        "mapping\" \"spherical\" \"float scale\" 0.5"));
  const SceneFile file = folder.read("scene.pbrt");
  const Material& material = file.scene.materials.at(index_of(file.scene.shapes.at(0).material));
  const Texture& texture = file.scene.textures.at(index_of(material.maps.at(0).texture));
  EXPECT_EQ(Vec3(texture.color(TexturePoint{})), Vec3(0.5f, 0, 0));
  EXPECT_EQ(texture.needs(), texture_needs::position);
}

TEST(PbrtMapping, WhatIsWrongOrNearlyThereIsTold) {
  const SceneFolder folder;
  folder.write("scene.pbrt",
               scene_of("Texture \"t\" \"spectrum\" \"checkerboard\" \"string mapping\" \"conical\""));
  EXPECT_TRUE(contains(folder.errors("scene.pbrt"), "6:40: error: there is no mapping 'conical'"))
      << folder.errors("scene.pbrt");
  const std::string scene =
      scene_of("Texture \"t\" \"spectrum\" \"checkerboard\" \"string mapping\" \"planar\"");
  folder.write("scene.pbrt", scene);
  EXPECT_FALSE(contains(folder.warnings(folder.read("scene.pbrt")), "approximated"));
  folder.write("scene.pbrt", scene + "ObjectBegin \"o\" Shape \"sphere\" ObjectEnd ObjectInstance \"o\"\n");
  EXPECT_TRUE(contains(folder.warnings(folder.read("scene.pbrt")), "on instances they move with them"));
}

}  // namespace
}  // namespace umbral
