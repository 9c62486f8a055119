// The program as a user meets it: commands, messages, exit codes, files.
#include <filesystem>
#include <fstream>
#include <functional>
#include <string>

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "image/film_file.h"
#include "support/command.h"

namespace umbral {
namespace {

namespace fs = std::filesystem;

using Outcome = test::CommandResult;

class Cli : public testing::Test {
 protected:
  Cli() : folder_(fs::temp_directory_path() / ("umbral_cli_" + std::to_string(getpid()))) {
    fs::create_directories(folder_);
    std::ofstream(folder_ / "room.toml") << R"([camera]
position = [0, 0, 3]
look_at = [0, 0, 0]
[film]
width = 16
height = 12
[sampling]
spp = 16
[materials.wall]
type = "blinn_phong"
kd = 0.5
ks = 0.2
[[shapes]]
type = "sphere"
material = "wall"
[[lights]]
type = "point"
position = [2, 3, 4]
intensity = 40
)";
  }
  ~Cli() override { fs::remove_all(folder_); }

  Outcome run(const std::string& arguments, const std::string& prefix = "") const {
    return test::run_command("cd '" + folder_.string() + "' && " + prefix + " " UMBRAL_PROGRAM " " +
                             arguments);
  }

  static bool has(const Outcome& outcome, const std::string& part) {
    return outcome.text.find(part) != std::string::npos;
  }

  fs::path folder_;
};

// A scene without a light of its own is not told of that where it is given one.
TEST_F(Cli, AnEnvironmentTakesThePlaceOfTheScenes) {
  std::ofstream(folder_ / "sky.ppm") << "P3 2 1 255\n255 0 0 255 0 0\n";
  std::ofstream(folder_ / "dark.ppm") << "P3 1 1 255\n0 0 0\n";
  std::ofstream(folder_ / "m.obj") << "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";
  std::ofstream(folder_ / "dark.toml")
      << "[materials.m]\ntype = \"matte\"\n[[shapes]]\ntype = \"sphere\"\nmaterial = \"m\"\n";
  EXPECT_TRUE(has(run("render m.obj --spp 8 --size 8x8 -o a.exr"), "no light is given"));
  EXPECT_TRUE(has(run("render dark.toml --spp 8 --size 8x8 -o a.exr"), "there is no light"));
  for (const char* scene : {"m.obj", "dark.toml"}) {
    const Outcome lit = run("render " + std::string(scene) + " --env sky.ppm --spp 8 --size 8x8 -o a.exr");
    EXPECT_EQ(lit.exit_code, 0) << lit.text;
    EXPECT_FALSE(has(lit, "no light")) << lit.text;
  }
  const Outcome dark = run("render m.obj --env dark.ppm --spp 8 --size 8x8 -o a.exr");
  EXPECT_EQ(dark.exit_code, 2);
  EXPECT_TRUE(has(dark, "dark.ppm: error: the image is black: no light")) << dark.text;
}

TEST_F(Cli, AnotherViewThanTheScenesOwn) {
  std::ofstream(folder_ / "two.gltf") << R"({"asset": {"version": "2.0"}, "scenes": [{"nodes": [0, 1, 2]}],
    "nodes": [{"mesh": 0}, {"camera": 0, "name": "front", "translation": [0, 0, 3]},
              {"camera": 0, "name": "behind", "translation": [0, 0, -3]}],
    "cameras": [{"type": "perspective", "perspective": {"yfov": 0.5, "znear": 1, "aspectRatio": 4}}],
    "meshes": [{"primitives": [{"attributes": {"POSITION": 0}}]}],
    "accessors": [{"bufferView": 0, "componentType": 5126, "count": 3, "type": "VEC3", "min": [0, 0, 0], "max": [1, 1, 0]}],
    "bufferViews": [{"buffer": 0, "byteLength": 36}],
    "buffers": [{"byteLength": 36, "uri": "data:application/octet-stream;base64,AAAAAAAAAAAAAAAAAACAPwAAAAAAAAAAAAAAAAAAgD8AAAAA"}]})";
  const std::string render = "render two.gltf --quiet --spp 1 --aux --pixel 530,118 ";
  const Outcome front = run(render);
  EXPECT_EQ(front.exit_code, 0) << front.text;
  EXPECT_NE(run(render + "--camera behind").text, front.text);  // sees nothing but the environment
  EXPECT_EQ(run(render + "--camera front --fov 28.64789").text, front.text);
  EXPECT_NE(run(render + "--look-at 9,9,9").text, front.text);
  EXPECT_TRUE(has(run(render + "--camera fron"), "there is no camera 'fron'; did you mean 'front'?"));
  EXPECT_TRUE(has(run(render + "--look-at 0,0,3"), "there is no direction to look in"));
  EXPECT_TRUE(has(run(render + "--up 0,0,1"), "give another --up"));
  EXPECT_TRUE(has(run(render + "--fov 180"), "--fov must be below 180"));
  EXPECT_TRUE(has(run(render + "--position 3e18,0,0"), "beyond the 1e+17 that rays can be traced to"));
  EXPECT_NE(run(render + "--look-at 1,2").exit_code, 0);
}

TEST_F(Cli, RendersBothFilesAndSaysHowExactTheyAre) {
  const Outcome outcome = run("render room.toml");
  EXPECT_EQ(outcome.exit_code, 0) << outcome.text;
  EXPECT_TRUE(has(outcome, "room.exr and room.png: 16 spp")) << outcome.text;
  EXPECT_TRUE(has(outcome, "% (RMS standard error of a pixel over the mean); mean ")) << outcome.text;
  EXPECT_TRUE(has(outcome, "uses analytic shapes, blinn_phong")) << outcome.text;
  EXPECT_TRUE(fs::exists(folder_ / "room.exr") && fs::exists(folder_ / "room.png"));
  const Outcome info = run("info room.exr");
  EXPECT_TRUE(has(info, "16 per pixel in 8 replicates, 0 rejected")) << info.text;
  EXPECT_TRUE(has(info, "bias         none")) << info.text;
}

TEST_F(Cli, ThreadsChangeNothing) {
  ASSERT_EQ(run("render room.toml --threads 1 -o a.exr").exit_code, 0);
  ASSERT_EQ(run("render room.toml --threads 2 -o b.exr").exit_code, 0);
  const ExrImage a = read_exr((folder_ / "a.exr").string()), b = read_exr((folder_ / "b.exr").string());
  for (const ExrChannel& channel : a.channels)
    EXPECT_EQ(channel.pixels, b.find(channel.name)->pixels) << channel.name;
}

TEST_F(Cli, LayersAreChannelsThatAddUp) {
  for (const std::string integrator : {"path", "blinn_phong"}) {
    ASSERT_EQ(run("render room.toml --layers --aux --integrator " + integrator + " -o l.exr").exit_code, 0);
    const FilmImage image = read_film((folder_ / "l.exr").string());
    ASSERT_GE(image.layers.size(), 3u);
    ASSERT_EQ(image.auxiliary.size(), image.pixels.size());
    for (std::size_t i = 0; i < image.pixels.size(); ++i) {
      Vec3 sum{0};
      for (const auto& layer : image.layers) sum += layer[i];
      EXPECT_NEAR(sum.r, image.pixels[i].mean.r, 1e-6 * (1 + sum.r));
    }
  }
}

TEST_F(Cli, ReplaysTheSampleThatAPixelIsMadeOf) {
  const Outcome one = run("render room.toml --pixel 8,6 --sample 3 --spp 1 --replicates 1");
  EXPECT_EQ(one.exit_code, 0) << one.text;
  EXPECT_TRUE(has(one, "pixel 8,6 sample 3 (replicate 0, index 3 within it, seed 0)")) << one.text;
  EXPECT_TRUE(has(one, "radiance"));
  EXPECT_EQ(run("render room.toml --pixel 8,6 --sample 3 --spp 1 --replicates 1").text, one.text);
  EXPECT_NE(run("render room.toml --pixel 8,6 --sample 3 --spp 1 --replicates 1 --seed 9").text, one.text);
}

TEST_F(Cli, JsonIsJson) {
  const Outcome outcome = run("render room.toml --json");
  const nlohmann::json json = nlohmann::json::parse(outcome.text);
  EXPECT_EQ(json["samplesPerPixel"], 16);
  EXPECT_GT(json["relativeError"].get<double>(), 0);
  EXPECT_EQ(json["biasNotes"].size(), 0u);
}

TEST_F(Cli, MergesRendersOfDifferentSeedsOnly) {
  ASSERT_EQ(run("render room.toml -o a.exr --seed 1").exit_code, 0);
  ASSERT_EQ(run("render room.toml -o b.exr --seed 2").exit_code, 0);
  const Outcome merged = run("merge a.exr b.exr -o ab.exr");
  EXPECT_EQ(merged.exit_code, 0) << merged.text;
  EXPECT_TRUE(has(run("info ab.exr"), "32 per pixel in 16 replicates"));
  EXPECT_EQ(run("merge a.exr a.exr -o aa.exr").exit_code, 2);
}

TEST_F(Cli, StopRulesSayWhichOneFired) {
  const Outcome reached = run("render room.toml --target-error 20%");
  EXPECT_TRUE(has(reached, "(target error 20 % reached: at most ")) << reached.text;
  EXPECT_TRUE(has(run("info room.exr"), "stopped by target error 20 % reached: at most "));
  EXPECT_TRUE(has(run("render room.toml --target-error 0.2"), "(target error 20 % reached: at most "));
  const Outcome missed = run("render room.toml --target-error 0.001% --spp 16");
  EXPECT_EQ(missed.exit_code, 4) << missed.text;
  EXPECT_TRUE(has(missed, "(samples; target error 0.001 % not reached: at most ")) << missed.text;
  EXPECT_TRUE(has(run("render room.toml --time 0.2"), "(time 0.2 s)"));
}

// Whether `interrupt(seconds)`, which sends the signal after so long, ends as it should. Later where nothing had begun by then:
// the machine may be busy.
bool ends_well(const std::function<bool(int)>& interrupt) {
  for (const int seconds : {2, 8, 32})
    if (interrupt(seconds)) return true;
  return false;
}

TEST_F(Cli, CtrlCWritesWhatThereIs) {
  EXPECT_TRUE(ends_well([&](int seconds) {
    run("render room.toml --spp 1000000000 --size 64x64", fmt::format("timeout -s INT {}", seconds));
    return fs::exists(folder_ / "room.exr");
  }));
  EXPECT_TRUE(has(run("info room.exr"), "stopped by interrupted"));
  for (const auto& entry : fs::directory_iterator(folder_)) {
    const std::string extension = entry.path().extension().string();
    EXPECT_TRUE(extension == ".toml" || extension == ".exr" || extension == ".png") << entry.path();
  }
}

TEST_F(Cli, AnInterruptedComparisonSaysThatThereIsNone) {
  EXPECT_TRUE(ends_well([&](int seconds) {
    const Outcome outcome =
        run("compare room.toml --samplers sobol,independent --spp 1000000 --json c.json -o c.html",
            fmt::format("timeout -s INT {}", seconds));
    return has(outcome, "interrupted: a comparison takes all its renders");
  }));
  EXPECT_FALSE(fs::exists(folder_ / "c.json") || fs::exists(folder_ / "c.html"));
}

TEST_F(Cli, ASignalThatComesTwiceAtOnceIsOne) {
  EXPECT_TRUE(ends_well([&](int seconds) {
    test::run_command(fmt::format("cd '{}' && " UMBRAL_PROGRAM
                                  " render room.toml --spp 1000000000 --size 800x600 & "
                                  "sleep {}; kill -INT $!; sleep 0.02; kill -INT $!; wait $!",
                                  folder_.string(), seconds));
    return fs::exists(folder_ / "room.exr");
  }));
}

TEST_F(Cli, BadArgumentsAreRefusedWithTheNearestName) {
  const auto refused = [&](const std::string& arguments, const std::string& message) {
    const Outcome outcome = run(arguments);
    EXPECT_EQ(outcome.exit_code, 2) << arguments;
    EXPECT_TRUE(has(outcome, message)) << arguments << "\n" << outcome.text;
  };
  refused("rendr room.toml", "there is no command 'rendr'; did you mean 'render'?");
  refused("render room.toml --integratr path",
          "there is no option '--integratr'; did you mean '--integrator'?");
  refused("--versio", "there is no option '--versio'; did you mean '--version'?");
  refused("converge room.toml --seed -1", "--seed: wants a whole number, 0 or above, not '-1'");
  refused("converge room.toml --time-limit -3", "--time-limit: wants a number above 0, not '-3'");
  refused("render room.toml --env --spp 1", "--env: wants a value before '--spp'");
  refused("check nosuch", "nosuch: error: cannot be read: No such file or directory");
  refused("render room.toml --integrator pth", "there is no integrator 'pth'; did you mean 'path'?");
  refused("render room.toml --sampler sobl", "did you mean 'sobol'?");
  refused("render room.toml --size 0x5", "--size wants WIDTHxHEIGHT");
  refused("render room.toml --crop 0,0,17,3", "--crop 16,2 is outside the image of 16x12 pixels");
  refused("render room.toml --crop 0,0,0,0", "--crop wants x0,y0,x1,y1 with x0 < x1 and y0 < y1");
  refused("render room.toml --time nan", "--time: wants a number above 0, not 'nan'");
  refused("render room.toml --time -1", "--time: wants a number above 0, not '-1'");
  refused("render room.toml --exposure inf", "--exposure: wants a number, not 'inf'");
  refused("render room.toml --seed -1", "--seed: wants a whole number, 0 or above, not '-1'");
  refused("render room.toml --pixel 16,0", "is outside the image");
  refused("render room.toml --sample 3", "--sample needs --pixel");
  refused("render room.toml --target-error nought", "--target-error wants a share above 0");
  refused("render room.toml --target-error 1% --replicates 1", "--target-error needs an error bar");
  refused("render room.toml --env none.hdr", "none.hdr");
  refused("render none.toml", "none.toml: error: ");
  refused("info room.toml", "room.toml: error: ");
  refused("help material mate", "did you mean 'matte'?");
  refused("help metarial", "did you mean 'material'?");
  refused("help torsu", "did you mean 'torus'?");
  refused("help zebra",
          "known are 'camera', 'film', 'sampling', 'integrator', 'material', 'texture', 'shape', 'light', "
          "'object', "
          "'instance' and 'include'");
}

TEST_F(Cli, UnwritableOutputIsToldBeforeTheRender) {
  const Outcome outcome = run("render room.toml -o none/room.exr --spp 1000000000");
  EXPECT_EQ(outcome.exit_code, 3);
  EXPECT_TRUE(has(outcome, "there is no directory '")) << outcome.text;
}

TEST_F(Cli, CheckCountsWarnings) {
  const Outcome outcome = run("check room.toml");
  EXPECT_EQ(outcome.exit_code, 0);
  EXPECT_TRUE(has(outcome, "room.toml: no errors, 0 warnings")) << outcome.text;
}

TEST_F(Cli, HelpExplainsEveryKindOfEveryGroup) {
  for (const std::string group :
       {"material", "texture", "shape", "light", "integrator", "camera", "film", "sampling"}) {
    const Outcome outcome = run("help " + group);
    EXPECT_EQ(outcome.exit_code, 0);
    EXPECT_TRUE(has(outcome, "default ")) << group;
  }
}

TEST_F(Cli, HelpFindsAKindInAnyGroupAndACommand) {
  const Outcome blinn_phong = run("help blinn_phong");
  EXPECT_EQ(blinn_phong.exit_code, 0);
  EXPECT_TRUE(has(blinn_phong, "integrator blinn_phong: ")) << blinn_phong.text;
  EXPECT_TRUE(has(blinn_phong, "\nmaterial blinn_phong: ")) << blinn_phong.text;
  EXPECT_TRUE(has(run("help merge"), "Usage: ")) << run("help merge").text;
}

}  // namespace
}  // namespace umbral
