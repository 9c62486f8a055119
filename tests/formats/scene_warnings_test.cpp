// What is legal but doubtful is told, and nothing else.
#include "formats/assembly/framing.h"
#include "scene_folder.h"

namespace umbral {
namespace {

using test::contains;
using test::SceneFolder;

constexpr const char* matte = "[materials.m]\ntype = \"matte\"\n";
constexpr const char* glass = "[materials.glass]\ntype = \"dielectric\"\n";
constexpr const char* environment = "[[lights]]\ntype = \"environment\"\n";
constexpr const char* camera = "[camera]\nposition = [0, 0, 5]\n";

std::string warnings_of(const std::string& text) {
  const SceneFolder folder;
  return folder.warnings(folder.read_toml(text));
}

std::string shape(const std::string& rest, const std::string& material = "m") {
  return "[[shapes]]\nmaterial = \"" + material + "\"\n" + rest + "\n";
}

constexpr const char* tetrahedron =
    "type = \"mesh\"\nvertices = [[-9, -9, -9], [30, -9, -9], [-9, 30, -9], [-9, -9, 30]]\n";

TEST(SceneWarnings, AGoodSceneHasNone) {
  EXPECT_EQ(warnings_of(std::string(camera) + matte + environment + shape("type = \"sphere\"")), "");
}

TEST(SceneWarnings, NoLight) {
  EXPECT_EQ(warnings_of(std::string(camera) + matte + shape("type = \"sphere\"")),
            "scene.toml: warning: there is no light: no shape emits, and there are no 'lights'\n");
}

TEST(SceneWarnings, FovOfAnOrthographicCamera) {
  EXPECT_EQ(
      warnings_of("[camera]\nposition = [0, 0, 5]\northographic_height = 3\nfov = 30\n" + std::string(matte) +
                  environment + shape("type = \"sphere\"")),
      "scene.toml:4:1: warning: 'fov' has no effect where 'orthographic_height' is given\n    4 | fov = 30\n"
      "      | ^\n");
}

TEST(SceneWarnings, CameraInsideClosedShapes) {
  const auto inside = [](const std::string& rest) {
    return warnings_of(std::string(camera) + matte + environment + shape(rest + "\nname = \"room\""));
  };
  const auto warned = [](const std::string& kind) {
    return "scene.toml:7:1: warning: the camera is inside " + kind +
           " 'room'\n    7 | [[shapes]]\n      | ^\n";
  };
  EXPECT_EQ(inside("type = \"sphere\"\nradius = 6"), warned("sphere"));
  EXPECT_EQ(inside("type = \"sphere\"\nradius = 4.9"), "");
  EXPECT_EQ(inside("type = \"sphere\"\ntransform = [{ translate = [0, 0, 5] }]"), warned("sphere"));
  EXPECT_EQ(inside("type = \"box\"\nhigh = [1, 1, 6]"), warned("box"));
  EXPECT_EQ(inside("type = \"box\""), "");
  EXPECT_EQ(inside("type = \"torus\"\nmajor_radius = 5\ntransform = [{ rotate = { axis = [1, 0, 0], degrees "
                   "= 90 } }]"),
            warned("torus"));
  EXPECT_EQ(inside("type = \"torus\"\nmajor_radius = 5"), "");
  EXPECT_EQ(inside(std::string(tetrahedron) + "faces = [[0, 2, 1], [0, 1, 3], [0, 3, 2], [1, 2, 3]]"),
            warned("mesh"));
  EXPECT_EQ(inside(std::string(tetrahedron) + "faces = [[0, 2, 1], [0, 1, 3], [0, 3, 2]]"), "") << "open";
}

TEST(SceneWarnings, CameraInsideAnInstance) {
  const std::string warnings =
      warnings_of(std::string(camera) + matte + environment +
                  "[objects.o]\n[[objects.o.shapes]]\ntype = \"sphere\"\nmaterial = \"m\"\n"
                  "[[instances]]\nobject = \"o\"\n"
                  "[[instances]]\nobject = \"o\"\ntransform = [{ translate = [0, 0, 5] }]\n");
  EXPECT_TRUE(contains(warnings, "the camera is inside sphere")) << warnings;
}

TEST(SceneWarnings, OpenDielectrics) {
  const auto of_glass = [](const std::string& rest) {
    return warnings_of(std::string(camera) + glass + environment + shape(rest, "glass"));
  };
  const std::string far_away = "\ntransform = [{ translate = [0, 0, -50] }]";
  EXPECT_EQ(
      of_glass("type = \"rectangle\""),
      "scene.toml:7:1: warning: rectangle is of dielectric 'glass' but is not closed: it has no inside\n"
      "    7 | [[shapes]]\n      | ^\n");
  EXPECT_TRUE(contains(of_glass("type = \"disk\""), "disk is of dielectric"));
  EXPECT_TRUE(
      contains(of_glass(std::string(tetrahedron) + "faces = [[0, 2, 1], [0, 1, 3], [0, 3, 2]]" + far_away),
               "mesh is of dielectric"));
  EXPECT_EQ(
      of_glass(std::string(tetrahedron) + "faces = [[0, 2, 1], [0, 1, 3], [0, 3, 2], [1, 2, 3]]" + far_away),
      "");
  EXPECT_EQ(of_glass("type = \"sphere\""), "");
  EXPECT_EQ(of_glass("type = \"box\""), "");
}

// A cube whose faces share no vertices, only positions, is closed.
TEST(SceneWarnings, SeamsDoNotOpenAMesh) {
  const std::string open = warnings_of(
      std::string(camera) + glass + environment +
      shape("type = \"mesh\"\n"
            "vertices = [[0,0,0],[1,0,0],[0,1,0], [0,0,0],[1,0,0],[0,0,1], [0,0,0],[0,1,0],[0,0,1], "
            "[1,0,0],[0,1,0],[0,0,1]]\n"
            "faces = [[0,2,1],[3,4,5],[6,8,7],[9,10,11]]",
            "glass"));
  EXPECT_EQ(open, "");
}

TEST(SceneWarnings, MoreThanAllIsReflected) {
  const std::string scene = std::string(camera) + environment + shape("type = \"sphere\"") +
                            "[materials.m]\ntype = \"blinn_phong\"\nks = 0.5\nkd = ";
  EXPECT_EQ(warnings_of(scene + "0.5\n"), "");
  EXPECT_EQ(warnings_of(scene + "[0.5, 0.75, 0.5]\n"),
            "scene.toml:8:12: warning: material 'm': kd + ks is 1.25; where it passes 1 both are scaled down "
            "so that no "
            "energy is made\n    8 | [materials.m]\n      |            ^\n");
  EXPECT_TRUE(
      contains(warnings_of(scene + "{ type = \"checker\", even = 0.9 }\n"), "kd + ks may reach 1.4;"));
}

TEST(SceneWarnings, EmittersThatAreBlackOrNotOpaque) {
  const std::string black = std::string(camera) + matte + environment +
                            shape("type = \"sphere\"\nemission = { type = \"checker\", even = 0, odd = 0 }");
  EXPECT_TRUE(contains(warnings_of(black), "the emission of sphere is black"));
  const std::string leaf = std::string(camera) + "[materials.leaf]\ntype = \"matte\"\nalpha = 0.5\n" +
                           shape("type = \"sphere\"\nemission = 1", "leaf");
  EXPECT_TRUE(contains(warnings_of(leaf), "sphere emits, but its material 'leaf' is not opaque"));
}

TEST(SceneWarnings, ShapesFarFromTheOrigin) {
  const std::string scene = std::string(camera) + matte + environment;
  const auto at = [&](const char* x) {
    return shape(std::string("type = \"sphere\"\ntransform = [{ translate = [") + x + ", 0, 0] }]");
  };
  EXPECT_EQ(warnings_of(scene + at("1000")), "");
  const std::string far = warnings_of(scene + at("1e6") + at("2e6"));
  EXPECT_TRUE(
      contains(far,
               "sphere is so far from the origin that its points are exact only to 1.1 of its size (so are "
               "1 more)"))
      << far;
}

// Finite numbers, but squares or inverses of them are not; the second of each is within the limit.
TEST(SceneErrors, NumbersBeyondWhatRaysCanBeTracedWith) {
  const auto errors = [](const std::string& text) {
    return SceneFolder().errors_of_toml(std::string(matte) + environment + text);
  };
  const std::string ball = shape("type = \"sphere\"");
  const auto far_ball = [&](const std::string& x) {
    return camera + shape("name = \"ball\"\ntype = \"sphere\"\ncenter = [" + x + ", 0, 0]");
  };
  EXPECT_EQ(
      errors(far_ball("2e18")),
      "scene.toml:7:1: error: sphere 'ball' reaches out to 2e+18, beyond the 1e+17 that rays can be traced "
      "to\n    7 | [[shapes]]\n      | ^");
  EXPECT_EQ(errors(far_ball("2e16")), "no error");
  const auto tiny = [&](const std::string& size) {
    return errors("[camera]\nposition = [0, 0, 5" + size + "]\n" +
                  shape("type = \"sphere\"\nradius = 1" + size));
  };
  EXPECT_TRUE(contains(tiny("e-20"), "all of the scene is within 5e-20 of the origin"));
  EXPECT_EQ(tiny("e-15"), "no error");
  const auto view = [&](const std::string& settings) { return errors(camera + settings + ball); };
  EXPECT_TRUE(contains(errors("[camera]\nposition = [2e18, 0, 5]\n" + ball), "the camera is at 2e+18"));
  EXPECT_TRUE(contains(view("lens_radius = 1e20\n"), "the camera's lens, fov, orthographic height or shift"));
  EXPECT_TRUE(
      contains(view("orthographic_height = 1e30\n"), "the camera's lens, fov, orthographic height or shift"));
  EXPECT_TRUE(contains(view("shift = [1e20, 0]\n"), "the camera's lens, fov, orthographic height or shift"));
  EXPECT_TRUE(contains(view("lens_radius = 1\nfocus_distance = 1e-30\n"),
                       "the camera's lens, fov, orthographic height or shift"));
  EXPECT_EQ(view("lens_radius = 1e10\nfov = 179.9\nshift = [1e10, 0]\n"), "no error");
  const auto lamp = [&](const std::string& settings) {
    return errors(camera + ball + "[[lights]]\ntype = \"point\"\n" + settings);
  };
  EXPECT_TRUE(contains(lamp("position = [0, 1e20, 0]\n"), "a light is at 1e+20"));
  EXPECT_TRUE(contains(lamp("intensity = 2e30\n"), "a light is brighter than the 1e+30"));
  EXPECT_EQ(lamp("intensity = 9e29\n"), "no error");
  EXPECT_TRUE(contains(errors(camera + shape("type = \"sphere\"\nemission = 2e30")), "sphere is brighter"));
  const auto instance = [&](const std::string& scale) {
    return errors(std::string(camera) +
                  "[objects.o]\n[[objects.o.shapes]]\ntype = \"sphere\"\nmaterial = \"m\"\n" +
                  "[[instances]]\nobject = \"o\"\ntransform = [{ scale = " + scale + " }]\n");
  };
  EXPECT_TRUE(contains(instance("1e-17"), "an instance of 'o' is too small or too flat"));
  EXPECT_EQ(instance("1e-15"), "no error");
}

TEST(SceneWarnings, NegativeAndMissingTexelsAreRepairedAndTold) {
  const SceneFolder folder;
  std::string pfm = "PF\n1 1\n-1.0\n";
  const float texel[3] = {std::nanf(""), 0.5f, -1};
  pfm.append(reinterpret_cast<const char*>(texel), sizeof(texel));
  folder.write("sky.pfm", pfm);
  const SceneFile file = folder.read_toml(std::string(camera) + matte + shape("type = \"sphere\"") +
                                          environment + "file = \"sky.pfm\"\n");
  const std::string warnings = folder.warnings(file);
  EXPECT_TRUE(contains(warnings, "scene.toml:10:8: warning: sky.pfm: ")) << warnings;
}

TEST(AutomaticCamera, FramesTheFrontOfTheScene) {
  const Bounds bounds{{-3, 10, -7}, {5, 12, 1}};
  for (const double aspect : {0.5, 1.0, 3.0}) {
    const CameraSettings settings = framing_camera(bounds, aspect);
    const int height = 100, width = static_cast<int>(height * aspect);
    const Camera seen_by(settings, width, height);
    const double distance = static_cast<double>(settings.position.z) - 1;
    ASSERT_GT(distance, 0);
    // The corners of the front face are in the image, and near its edge in one direction at least.
    const auto seen = [&](const Vec2& pixel) {
      const Vec3 d = seen_by.ray(pixel, {0.5f, 0.5f}).d;
      return Vec3d(settings.position) + Vec3d(d) * (distance / -static_cast<double>(d.z));
    };
    const Vec3d corner = seen({static_cast<float>(width), 0});
    EXPECT_GT(corner.x, 5);
    EXPECT_GT(corner.y, 12);
    EXPECT_LT(std::min((corner.x - 1) / 4, (corner.y - 11) / 1), 1.3);
  }
}

TEST(AutomaticCamera, SeesFlatThingsFromTheirFace) {
  const auto view = [](const Vec3d& half) {
    const CameraSettings settings = framing_camera({-half, half}, 1.5);
    const Camera seen_by(settings, 150, 100);
    // All corners are in the image.
    for (int corner = 0; corner < 8; ++corner) {
      const Vec3 p = Vec3(half) * Vec3(corner & 1 ? 1 : -1, corner & 2 ? 1 : -1, corner & 4 ? 1 : -1);
      const Vec3 forward = seen_by.forward(), right = glm::normalize(cross(forward, settings.up));
      const Vec3 d = p - settings.position;
      const float slope = std::tan(glm::radians(settings.fov / 2)) * dot(d, forward);
      EXPECT_LT(std::abs(dot(d, right)), 1.5f * slope);
      EXPECT_LT(std::abs(dot(d, cross(right, forward))), slope);
    }
    return seen_by.forward();
  };
  EXPECT_EQ(view({2, 1, 2}), Vec3(0, 0, -1));
  EXPECT_EQ(view({0, 1, 0}), Vec3(0, 0, -1));
  EXPECT_EQ(view({0, 1, 2}), Vec3(-1, 0, 0));
  EXPECT_LT(glm::length(view({2, 0, 2}) - glm::normalize(Vec3(0, -1, -1))), 1e-6f);
  EXPECT_EQ(view({2, 0.1, 0}), Vec3(0, 0, -1));
}

TEST(AutomaticCamera, StandsInForAMissingOne) {
  const SceneFolder folder;
  const SceneFile file = folder.read_toml(std::string(matte) + environment + shape("type = \"sphere\""));
  EXPECT_EQ(folder.warnings(file),
            "scene.toml: warning: no camera is given; it is put at [0, 0, 4.0222], looking at [0, 0, 0]\n");
}

// What textures ask of a mesh and it has not.
TEST(SceneWarnings, MissingAttributesOfMeshes) {
  const std::string triangle =
      "type = \"mesh\"\nvertices = [[0, 0, 0], [1, 0, 0], [0, 1, 0]]\nfaces = [[0, 1, 2]]\n";
  const auto warnings = [&](const std::string& parameter, const std::string& attributes = "") {
    return warnings_of(std::string(camera) + "[materials.m]\ntype = \"matte\"\n" + parameter + environment +
                       shape(triangle + attributes));
  };
  const std::string color = "reflectance = { type = \"vertex_color\" }\n";
  EXPECT_TRUE(
      contains(warnings(color), "mesh has no vertex colours, which textures of 'm' ask for: they are white"));
  EXPECT_EQ(warnings(color, "colors = [[1, 0, 0], [0, 1, 0], [0, 0, 1]]\n"), "");
  const std::string second = "reflectance = { type = \"checker\", uv_set = 1 }\n";
  EXPECT_TRUE(
      contains(warnings(second), "mesh has no second uv, which textures of 'm' ask for: the first is used"));
  EXPECT_EQ(warnings(second, "uvs1 = [[0, 0], [1, 0], [0, 1]]\n"), "");
  EXPECT_TRUE(contains(warnings("normal_map = { type = \"checker\" }\n"), "mesh has no uv"));
  EXPECT_TRUE(contains(warnings("bump_map = 0.5\n"), "no slope and no effect"));
  EXPECT_TRUE(
      contains(warnings("", "colors = [[1, 0, 0], [0, 1, 0], [0, 0, 2]]\n"), "cut 1 vertex colour to 0 … 1"));
}

}  // namespace
}  // namespace umbral
