// No include of src/ goes against the arrows between its rooms, and one that did would be named.
#include <gtest/gtest.h>

#include <fstream>
#include <ostream>
#include <string>
#include <vector>

#include "architecture/includes.h"
#include "support/paths.h"

namespace umbral::test {
namespace {

TEST(Arrows, NoIncludeOfTheSourcesGoesAgainstThem) {
  const Inspection inspection = inspect_includes(source_path("src"));
  EXPECT_EQ(inspection.rooms, (std::vector<std::string>{"analysis", "app", "bsdf", "core", "formats", "image",
                                                        "integrators", "render", "report", "scene"}));
  for (const Violation& violation : inspection.violations) ADD_FAILURE() << violation.text();
}

// A tree with the headers that the cases below include and with one more file.
class SmallTree {
 public:
  SmallTree(const std::string& file, const std::string& include) {
    for (const char* header :
         {"core/math.h", "image/film.h", "image/exr.h", "image/image.h", "analysis/equality.h", "bsdf/bsdf.h",
          "bsdf/facets/microfacet.h", "bsdf/layers/skin.h", "scene/scene.h", "formats/toml.h",
          "integrators/integrator.h", "render/render.h"})
      write(header, "#pragma once\n");
    write(file, "// A comment.\n// #include \"app/not_an_include.h\"\n#include " + include + "\n");
  }

  std::vector<Violation> violations() const { return inspect_includes(directory_.path()).violations; }

 private:
  void write(const std::filesystem::path& file, const std::string& text) const {
    const std::filesystem::path path = directory_.path() / file;
    std::filesystem::create_directories(path.parent_path());
    std::ofstream(path) << text;
  }

  TemporaryDirectory directory_;
};

TEST(Arrows, AFolderThatIsNoRoomIsNamed) {
  const std::vector<Violation> violations = SmallTree("viewer/a.cpp", "<vector>").violations();
  ASSERT_EQ(violations.size(), 1u);
  EXPECT_EQ(violations[0].text(), "src/viewer/a.cpp:1: 'viewer' is not a room of src/");
}

struct Case {
  std::string file, include, reason;  // the reason in part; empty: allowed
};

void PrintTo(const Case& c, std::ostream* stream) { *stream << c.file << " includes " << c.include; }

class OneInclude : public testing::TestWithParam<Case> {};

TEST_P(OneInclude, IsNamedExactlyWhenItIsForbidden) {
  const std::vector<Violation> violations = SmallTree(GetParam().file, GetParam().include).violations();
  if (GetParam().reason.empty()) {
    for (const Violation& violation : violations) ADD_FAILURE() << violation.text();
    return;
  }
  ASSERT_EQ(violations.size(), 1u);
  EXPECT_EQ(violations[0].file, GetParam().file);
  EXPECT_EQ(violations[0].line, 3);
  EXPECT_EQ(violations[0].include, GetParam().include);
  EXPECT_NE(violations[0].reason.find(GetParam().reason), std::string::npos) << violations[0].reason;
  EXPECT_EQ(violations[0].text().find("src/" + GetParam().file + ":3: #include " + GetParam().include), 0u);
}

INSTANTIATE_TEST_SUITE_P(
    Forbidden, OneInclude,
    testing::Values(
        Case{"core/a.h", "\"image/film.h\"", "core may include itself only"},
        Case{"core/a.cpp", "\"scene/scene.h\"", "core may include itself only"},
        Case{"image/a.h", "\"bsdf/bsdf.h\"", "image may include itself, core"},
        Case{"bsdf/a.h", "\"image/image.h\"", "bsdf may include itself, core"},
        Case{"bsdf/a.h", "\"scene/scene.h\"", "bsdf may include itself, core"},
        Case{"bsdf/facets/a.h", "\"bsdf/layers/skin.h\"", "build on one another"},
        Case{"analysis/a.h", "\"scene/scene.h\"", "analysis may include itself, core, image"},
        Case{"render/a.cpp", "\"analysis/equality.h\"", "render may include"},
        Case{"scene/shapes/a.h", "\"formats/toml.h\"", "scene may include itself, core, image, bsdf"},
        Case{"scene/a.h", "\"integrators/integrator.h\"", "scene may include"},
        Case{"formats/a.cpp", "\"integrators/integrator.h\"", "formats may include"},
        Case{"formats/a.cpp", "\"render/render.h\"", "formats may include"},
        Case{"integrators/a.cpp", "\"formats/toml.h\"", "integrators may include"},
        Case{"integrators/a.cpp", "\"render/render.h\"", "integrators may include"},
        Case{"integrators/a.cpp", "\"image/film.h\"", "never sees films"},
        Case{"integrators/a.h", "\"image/exr.h\"", "never sees films"},
        Case{"scene/a.h", "\"image/film.h\"", "never sees films"},
        Case{"render/a.cpp", "\"formats/toml.h\"", "render may include"},
        Case{"core/a.h", "\"math.h\"", "no such file"},
        Case{"scene/a.h", "\"scene/absent.h\"", "no such file"},
        Case{"scene/a.cpp", "<OpenImageIO/imageio.h>", "OpenImageIO belongs in image"},
        Case{"render/a.cpp", "<ImfOutputFile.h>", "OpenEXR belongs in image"},
        Case{"app/a.cpp", "<OpenEXR/ImfInputFile.h>", "OpenEXR belongs in image"},
        Case{"scene/scene.cpp", "<embree3/rtcore.h>", "Embree belongs in scene/accel"},
        Case{"integrators/a.cpp", "<embree4/rtcore.h>", "Embree belongs in scene/accel"},
        Case{"scene/a.cpp", "<toml++/toml.h>", "toml++ belongs in formats"},
        Case{"render/a.cpp", "<CLI/CLI.hpp>", "CLI11 belongs in app"},
        Case{"scene/a.cpp", "<nlohmann/json.hpp>", "nlohmann/json belongs in app, formats"},
        Case{"render/a.cpp", "<tbb/parallel_for.h>", "oneTBB belongs in core"},
        Case{"bsdf/a.cpp", "<boost/math/distributions/students_t.hpp>", "Boost.Math belongs in core"},
        Case{"render/a.cpp", "<iostream>", "the standard output belongs in app"},
        Case{"core/a.cpp", "<Eigen/Dense>", "no library in the table"}));

INSTANTIATE_TEST_SUITE_P(
    Allowed, OneInclude,
    testing::Values(
        Case{"core/a.h", "\"core/math.h\"", ""}, Case{"core/a.cpp", "<tbb/parallel_for.h>", ""},
        Case{"core/a.cpp", "<boost/math/distributions/students_t.hpp>", ""},
        Case{"app/a.cpp", "\"analysis/equality.h\"", ""}, Case{"analysis/a.h", "\"image/exr.h\"", ""},
        Case{"image/a.cpp", "<OpenEXR/ImfOutputFile.h>", ""},
        Case{"image/a.cpp", "<OpenImageIO/imageio.h>", ""}, Case{"scene/a.h", "\"image/image.h\"", ""},
        Case{"scene/accel.cpp", "<embree3/rtcore.h>", ""},
        Case{"scene/accel_embree.h", "<embree4/rtcore.h>", ""}, Case{"formats/a.cpp", "<toml++/toml.h>", ""},
        Case{"formats/a.h", "\"scene/scene.h\"", ""}, Case{"integrators/a.h", "\"scene/scene.h\"", ""},
        Case{"render/a.h", "\"image/film.h\"", ""}, Case{"render/a.cpp", "\"integrators/integrator.h\"", ""},
        Case{"app/a.cpp", "\"formats/toml.h\"", ""}, Case{"app/a.cpp", "<CLI/CLI.hpp>", ""},
        Case{"app/a.cpp", "\"umbral_version.h\"", ""}, Case{"bsdf/a.h", "<fmt/format.h>", ""},
        Case{"bsdf/layers/a.h", "\"bsdf/facets/microfacet.h\"", ""}, Case{"scene/a.h", "<glm/glm.hpp>", ""}));

}  // namespace
}  // namespace umbral::test
