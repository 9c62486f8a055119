// Golden messages of TOML scene files: text, place, excerpt and caret of every kind of error.
#include <vector>

#include "scene_folder.h"

namespace umbral {
namespace {

using test::SceneFolder;

struct Golden {
  std::string name, scene, message;
};

// GoogleTest would list a case by its bytes, which CMake cannot read.
void PrintTo(const Golden& golden, std::ostream* stream) { *stream << golden.name; }

// The cases of toml_errors.txt.
std::vector<Golden> goldens() {
  std::ifstream file(test::source_path("tests/formats/toml_errors.txt"));
  std::vector<Golden> cases;
  std::string* part = nullptr;
  for (std::string line; std::getline(file, line);) {
    if (line.starts_with("=== ")) {
      cases.push_back({line.substr(4), "", ""});
      part = &cases.back().scene;
    } else if (line == "---") {
      part = &cases.back().message;
    } else if (part) {
      *part += line + '\n';
    }
  }
  return cases;
}

class GoldenTomlErrors : public testing::TestWithParam<Golden> {};

TEST_P(GoldenTomlErrors, HaveThisText) {
  const SceneFolder folder;
  folder.write("black.tga", test::tga(2, 2, 0, 0, 0, 255));
  folder.write("white.tga", test::tga(2, 2, 255, 255, 255, 255));
  folder.write("empty.ply", "");
  folder.write("empty.ies", "");
  EXPECT_EQ(folder.errors_of_toml(GetParam().scene) + '\n', GetParam().message);
}

INSTANTIATE_TEST_SUITE_P(All, GoldenTomlErrors, testing::ValuesIn(goldens()),
                         [](const testing::TestParamInfo<Golden>& golden) { return golden.param.name; });

TEST(TomlErrors, AreCheckedInNumber) { EXPECT_GE(goldens().size(), 93u); }

// The words are those of toml++ and differ between its versions.
TEST(TomlErrors, OfSyntaxAreLocated) {
  const SceneFolder folder;
  const auto tells = [&](const std::string& scene, const std::string& line, const std::string& excerpt) {
    const std::string errors = folder.errors_of_toml(scene);
    EXPECT_TRUE(errors.starts_with("scene.toml:" + line + ":")) << errors;
    EXPECT_TRUE(test::contains(errors, ": error: ")) << errors;
    EXPECT_TRUE(test::contains(errors, "\n    " + line + " | " + excerpt + "\n      | ")) << errors;
  };
  tells("[film]\nwidth = 1\nwidth = 2\n", "3", "width = 2");
  tells("[film]\nwidth = 1\n[film]\nheight = 2\n", "3", "[film]");
  tells("[film]\nwidth = = 1\n", "2", "width = = 1");
  tells("[film]\nfilter = \"box\n", "2", "filter = \"box");
  tells("[film]\nwidth = 1 # \xff\n", "2", "width = 1 # \xff");
}

TEST(TomlErrors, AreAllToldAtOnceInTheOrderOfTheFile) {
  const SceneFolder folder;
  folder.write("scene.toml", R"([film]
width = "wide"

[camera]
fov = 200

[[shapes]]
type = "sphere"
material = "nothing"
radius = 0
)");
  try {
    folder.read("scene.toml");
    FAIL() << "no error";
  } catch (const SceneError& error) {
    std::vector<int> lines;
    for (const Diagnostic& diagnostic : error.diagnostics()) {
      lines.push_back(diagnostic.where.line);
      EXPECT_EQ(diagnostic.severity, Severity::error);
    }
    EXPECT_EQ(lines, (std::vector<int>{2, 5, 9, 10}));
  }
}

TEST(TomlErrors, OfIncludedFilesComeAfterThoseOfTheSceneItself) {
  const SceneFolder folder;
  folder.write("bad.obj", "v 0 0 0\nf 1 2 3\n");
  const std::string errors = folder.errors_of_toml(R"([[include]]
file = "bad.obj"

[film]
width = 0
)");
  EXPECT_LT(errors.find("scene.toml:5:9"), errors.find("bad.obj:2:5"));
  EXPECT_NE(errors.find("bad.obj:2:5"), std::string::npos);
}

TEST(TomlErrors, CaretStandsUnderTheCharacterNotTheByte) {
  const SceneFolder folder;
  EXPECT_EQ(folder.errors_of_toml("camera = { position = [0, 0, 5], \"größe\" = 1 }\n"),
            "scene.toml:1:34: error: 'größe' is not a parameter of 'camera'; known are 'position', "
            "'look_at', 'up', "
            "'fov', 'orthographic_height', 'lens_radius', 'focus_distance', 'mirrored' and 'shift'\n"
            "    1 | camera = { position = [0, 0, 5], \"größe\" = 1 }\n"
            "      |                                  ^");
}

TEST(TomlErrors, LongLinesAreCutAroundTheCaret) {
  const SceneFolder folder;
  const std::string errors =
      folder.errors_of_toml("[film]\nfilter = \"" + std::string(500, 'x') + "\"\nwidth = 0\n");
  std::istringstream lines(errors);
  std::string line;
  while (std::getline(lines, line)) EXPECT_TRUE(line.size() <= 108 || !line.starts_with("    2 |")) << line;
  EXPECT_TRUE(test::contains(errors, "scene.toml:3:9"));
}

TEST(TomlErrors, AMissingSceneFileIsNamed) {
  const SceneFolder folder;
  EXPECT_EQ(folder.errors("none.toml"), "none.toml: error: cannot be read: No such file or directory");
  EXPECT_EQ(folder.errors("none"), "none: error: cannot be read: No such file or directory");
  folder.write("some", "text");
  EXPECT_EQ(folder.errors("some"),
            "some: error: the name of a scene file must end in .toml, .pbrt, .xml, .gltf, .glb, .obj, .ply "
            "or .stl");
}

}  // namespace
}  // namespace umbral
