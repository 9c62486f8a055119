// umbral converge as a user meets it: numbers, expectations, exit codes and files.
#include <fstream>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "support/chromium.h"
#include "support/command.h"
#include "support/contents.h"
#include "support/paths.h"

namespace umbral {
namespace {

using Outcome = test::CommandResult;

// A ball that light from all sides does not change: its radiance is 0.5 wherever one looks, by any number of bounces.
constexpr const char* furnace = R"([camera]
position = [0, 0, 3]
look_at = [0, 0, 0]
[film]
width = 8
height = 8
filter = "box"
[materials.wall]
type = "matte"
reflectance = 0.5
[[shapes]]
type = "sphere"
radius = 1
material = "wall"
emission = 0.25
[[shapes]]
type = "sphere"
radius = 5
material = "wall"
emission = 0.25
two_sided = true
)";

class Converge : public testing::Test {
 protected:
  Converge() { std::ofstream(path("scene.toml")) << furnace; }

  std::string path(const std::string& name) const { return (directory_.path() / name).string(); }

  Outcome run(const std::string& arguments) const {
    return test::run_command("cd '" + directory_.path().string() + "' && " UMBRAL_PROGRAM " " + arguments);
  }

  std::string contents(const std::string& name) const { return test::contents(path(name)); }

  test::TemporaryDirectory directory_;
};

void expect(const Outcome& outcome, int exit_code, const std::string& part) {
  EXPECT_EQ(outcome.exit_code, exit_code) << outcome.text;
  EXPECT_NE(outcome.text.find(part), std::string::npos) << outcome.text;
}

// The slope of independent samples is −1 whatever the scene; 0.1 is some four standard errors with 32 replicates.
TEST_F(Converge, IndependentSamplesHaveSlopeMinusOne) {
  const Outcome outcome =
      run("converge scene.toml --samplers independent --replicates 32 --spp-range 4..64 --oracle 0.5 "
          "--expect-equal "
          "--expect-slope -0.9 --json out.json");
  expect(outcome, 0, "holds     path, equal");
  const nlohmann::json json = nlohmann::json::parse(contents("out.json"));
  const nlohmann::json& curve = json["curves"][0];
  EXPECT_NEAR(curve["slope"]["value"].get<double>(), -1, 0.1);
  ASSERT_EQ(curve["points"].size(), 5u);
  EXPECT_EQ(curve["points"][4]["samples"], 64);
  EXPECT_NEAR(json["mean"].get<double>(), 0.5, 1e-9);
  // 1/(V T) of the last point.
  const nlohmann::json& last = curve["points"][4];
  EXPECT_NEAR(last["efficiency"]["value"].get<double>() * last["relativeVariance"]["value"].get<double>() *
                  last["seconds"]["value"].get<double>(),
              1, 1e-9);
}

TEST_F(Converge, SaysWhichExpectationFails) {
  const Outcome outcome = run(
      "converge scene.toml --samplers independent,sobol --spp-range 4..64 --expect-slope -2 --expect-equal "
      "--junit out.xml");
  expect(outcome, 1, "FAILS     independent, slope: slope −");
  const std::string xml = contents("out.xml");
  EXPECT_NE(xml.find("<failure type=\"differs\""), std::string::npos) << xml;
  EXPECT_NE(xml.find("classname=\"sobol\" name=\"equal\""), std::string::npos) << xml;
}

TEST_F(Converge, AWrongOracleIsNotReached) {
  expect(run("converge scene.toml --spp-range 16..64 --oracle 0.6 --expect-equal"), 1, "differ: ");
  expect(run("converge scene.toml --spp-range 16..64 --oracle 0.5,0.5,0.52 --expect-equal"), 1, "differ: ");
}

TEST_F(Converge, MoreBouncesAreSlowerAndBiasIsTold) {
  const Outcome outcome =
      run("converge scene.toml --set path.max_depth=1,20 --spp-range 4..64 --expect-equal --clock cpu");
  expect(outcome, 1, "'max_depth=20' and 'max_depth=1' differ");
  EXPECT_NE(outcome.text.find("biased: "), std::string::npos) << outcome.text;
  EXPECT_NE(outcome.text.find("seconds of all threads together"), std::string::npos) << outcome.text;
}

TEST_F(Converge, AReferenceMayHaveNoiseOfItsOwn) {
  ASSERT_EQ(run("render scene.toml --spp 4096 --seed 5 -o reference.exr").exit_code, 0);
  const Outcome outcome =
      run("converge scene.toml --spp-range 4..32 --reference reference.exr --expect-equal");
  expect(outcome, 0, "'path' and 'reference.exr' are equal within noise");
}

// Against as few samples as its own, nothing can be said; it must not be said either.
TEST_F(Converge, ANoisyReferenceDrownsWhatItCannotTell) {
  ASSERT_EQ(run("render scene.toml --spp 16 --seed 5 -o reference.exr").exit_code, 0);
  expect(run("converge scene.toml --spp-range 16..256 --reference reference.exr"), 4,
         "drowned by the noise of reference.exr");
}

TEST_F(Converge, TellsWhatATargetTakesOrThatItWasNotReached) {
  expect(run("converge scene.toml --samplers independent --spp-range 4..64 --target-error 5%"), 0,
         "5 % takes ");
  expect(run("converge scene.toml --samplers independent --spp-range 4..64 --target-error 0.1%"), 4,
         "(extrapolated)");
}

TEST_F(Converge, ATimeLimitEndsEarlyAndSaysSo) {
  const Outcome outcome = run("converge scene.toml --spp-range 4..1048576 --time-limit 1");
  const bool has_slope = outcome.text.find("of log variance against log spp") != std::string::npos;
  // A slow build does not get to three numbers of samples in a second.
  expect(outcome, has_slope ? 0 : 4, "ended by the time limit");
}

TEST_F(Converge, BadInputIsRefused) {
  const auto refused = [&](int code, const std::string& arguments, const std::string& message) {
    expect(run("converge " + arguments), code, message);
  };
  refused(2, "nothing.toml", "nothing.toml: error: cannot be read");
  refused(2, "scene.toml --replicates 15", "Value 15 not in range");
  refused(2, "scene.toml --spp-range 4..15", "fewer than three numbers of samples");
  refused(2, "scene.toml --spp-range 4-64", "wants FIRST..LAST");
  refused(2, "scene.toml --set sampling.replicates=8 --spp-range 4..64", "must begin at a multiple");
  refused(2, "scene.toml --samplers sobol,sobol", "'sobol' is asked for twice");
  refused(2, "scene.toml --samplers sobol,independent --expect-faster x", "there is no variant 'x'");
  refused(2, "scene.toml --expect-equal", "nothing to be equal to");
  refused(2, "scene.toml --reference nothing.exr", "nothing.exr: error: there is no such file");
  refused(3, "scene.toml --html nowhere/out.html", "cannot write 'nowhere/out.html'");
  ASSERT_EQ(run("render scene.toml --size 9x8 -o wide.exr").exit_code, 0);
  refused(5, "scene.toml --reference wide.exr", "wide.exr has 9 x 8 pixels, and the scene's image 8 x 8");
  ASSERT_EQ(run("render scene.toml --replicates 1 -o one.exr").exit_code, 0);
  refused(9, "scene.toml --reference one.exr", "one replicate");
}

TEST_F(Converge, AnImageWithoutNoiseOrLightIsRefused) {
  std::ofstream(path("dark.toml")) << R"([camera]
position = [0, 0, 3]
look_at = [0, 0, 0]
[film]
width = 4
height = 4
[materials.wall]
type = "matte"
[[shapes]]
type = "sphere"
material = "wall"
)";
  expect(run("converge dark.toml --spp-range 4..16"), 2, "the image is black");
}

TEST_F(Converge, ThePageShowsBothPlotsAndHoldsTheNumbers) {
  if (!test::chromium()) GTEST_SKIP() << test::no_chromium;
  const Outcome outcome = run(
      "converge scene.toml --samplers independent,sobol --spp-range 4..64 --target-error 5% --quiet --html "
      "out.html --svg out.svg --json out.json");
  EXPECT_NE(outcome.exit_code, 2) << outcome.text;
  EXPECT_EQ(outcome.text, "");
  const nlohmann::json seen = test::run_in_page(path("out.html"), R"(
    const plots = [...document.querySelectorAll('.plot')];
    const shown = () => plots.map(p => [...p.querySelectorAll('.series')]
                                           .filter(e => getComputedStyle(e).display !== 'none').length);
    const before = shown();
    plots[0].querySelectorAll('.key')[1].dispatchEvent(new MouseEvent('click'));
    return {titles: plots.map(p => p.querySelector('.title').textContent), before, after: shown(),
            points: plots.map(p => p.querySelectorAll('.point').length),
            bars: plots.map(p => p.querySelectorAll('.bar').length),
            checks: document.querySelectorAll('#checks tr').length,
            data: JSON.parse(document.getElementById('data').textContent), failures, requests};)");
  EXPECT_EQ(seen["titles"], (nlohmann::json{"Error against samples", "Error against seconds"})) << seen;
  EXPECT_EQ(seen["points"], (nlohmann::json{10, 10}));
  EXPECT_EQ(seen["bars"], (nlohmann::json{10, 20}));
  EXPECT_EQ(seen["before"], (nlohmann::json{2, 2}));
  EXPECT_EQ(seen["after"], (nlohmann::json{1, 1}));
  EXPECT_EQ(seen["checks"], 3);
  EXPECT_EQ(seen["data"], nlohmann::json::parse(contents("out.json")));
  EXPECT_EQ(seen["failures"].size() + seen["requests"].size(), 0u) << seen;
  EXPECT_EQ(contents("out.svg").rfind("<?xml", 0), 0u);
}

}  // namespace
}  // namespace umbral
