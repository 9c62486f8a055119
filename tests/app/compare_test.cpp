// `umbral compare` as a user meets it: its verdicts, every input that it refuses, and the exit code of each.
#include <filesystem>
#include <fstream>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "image/exr.h"
#include "support/command.h"
#include "support/paths.h"
#include "support/random.h"

namespace umbral::test {
namespace {

namespace fs = std::filesystem;

// An image of noise around `mean`, as umbral would write it unless told otherwise.
struct NoisyImage {
  int width = 32, height = 32;
  double mean = 0.5, error = 0.002;  // of a pixel
  std::uint64_t seed = 1;
  bool ours = true;
  int replicates = 8;

  ExrImage exr() const {
    ExrImage exr{width, height, 0, 0, width, height, {}, {}};
    Random random(1000 + seed);
    const std::size_t n = static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
    for (const char* name : {"B", "G", "R"}) {
      ExrChannel channel{name, std::vector<float>(n)};
      ExrChannel errors{std::string("stderr.") + name, std::vector<float>(n, static_cast<float>(error))};
      for (float& value : channel.pixels) {
        double sum = -6;  // twelve uniform numbers: variance 1
        for (int k = 0; k < 12; ++k) sum += random.number();
        value = static_cast<float>(mean + error * sum);
      }
      exr.channels.push_back(std::move(channel));
      if (ours) exr.channels.push_back(std::move(errors));
    }
    if (!ours) return exr;
    exr.attributes["umbral:replicates"] = replicates;
    exr.attributes["umbral:seeds"] = std::to_string(seed);
    exr.attributes["umbral:integrator"] = std::string("path()");
    exr.attributes["umbral:samplesPerPixel"] = 64.0;
    return exr;
  }
};

class Compare : public testing::Test {
 protected:
  void write(const std::string& name, const ExrImage& exr) const { write_exr(path(name), exr); }
  void write(const std::string& name, const NoisyImage& image) const { write(name, image.exr()); }
  std::string path(const std::string& name) const { return (folder_.path() / name).string(); }

  CommandResult compare(const std::string& arguments) const {
    return run_command("cd '" + folder_.path().string() + "' && " UMBRAL_PROGRAM " compare " + arguments);
  }
  void expect(const std::string& arguments, int exit_code, const std::string& part) const {
    const CommandResult result = compare(arguments);
    EXPECT_EQ(result.exit_code, exit_code) << arguments << "\n" << result.text;
    EXPECT_NE(result.text.find(part), std::string::npos) << arguments << "\n" << result.text;
  }

  TemporaryDirectory folder_;
};

TEST_F(Compare, SaysEqualDifferOrTooNoisyToTell) {
  write("a.exr", NoisyImage{});
  write("equal.exr", NoisyImage{.seed = 2});
  write("brighter.exr", NoisyImage{.mean = 0.503, .seed = 3});
  write("noisy.exr", NoisyImage{.error = 0.2, .seed = 4});
  expect("a.exr equal.exr", 0, "equal within noise");
  expect("a.exr brighter.exr", 1, "differ");
  expect("a.exr noisy.exr", 4, "not enough samples");
  expect("a.exr noisy.exr --image-mde 0.2 --tile-mde 0.5", 0, "equal within noise");
}

TEST_F(Compare, TellsTheChangeWithItsError) {
  write("a.exr", NoisyImage{});
  write("b.exr", NoisyImage{.mean = 0.75, .seed = 2});
  const CommandResult result = compare("a.exr b.exr --json out.json --region left=0,0,16,32");
  const nlohmann::json json = nlohmann::json::parse(std::ifstream(path("out.json")));
  EXPECT_EQ(json["verdict"], "differ");
  EXPECT_NEAR(json["image"]["change"], 0.5, 0.002);
  // Of fully correlated channels: 1.96·√(0.002² + (1.5·0.002)²)/0.5/32.
  EXPECT_NEAR(json["image"]["halfWidth95"], 1.96 * 0.0036056 / 0.5 / 32, 2e-6);
  ASSERT_EQ(json["regions"].size(), 1u);
  EXPECT_EQ(json["regions"][0]["region"], "left");
  EXPECT_NEAR(json["metrics"]["MSE"]["measured"], 0.0625, 1e-4);
  EXPECT_NE(result.text.find("left         +50."), std::string::npos) << result.text;
}

TEST_F(Compare, SeedsOfAnybodyAreReplicates) {
  std::string a = "-a", b = "-b", c = "-b";
  for (std::uint64_t seed = 0; seed < 8; ++seed) {
    const std::string number = std::to_string(seed) + ".exr";
    write("a" + number, NoisyImage{.seed = seed, .ours = false});
    write("b" + number, NoisyImage{.seed = 100 + seed, .ours = false});
    write("c" + number, NoisyImage{.mean = 0.502, .seed = 200 + seed, .ours = false});
    a += " a" + number;
    b += " b" + number;
    c += " c" + number;
  }
  expect(a + " " + b, 0, "8 whole images");
  expect(a + " " + c, 1, "differ");
}

TEST_F(Compare, WithoutErrorBarsThereIsNoVerdictButThereAreMetrics) {
  write("ours.exr", NoisyImage{});
  write("theirs.exr", NoisyImage{.seed = 2, .ours = false});
  expect("ours.exr theirs.exr", 8, "nothing is known of the error of theirs.exr");
  expect("ours.exr theirs.exr", 8, "FLIP");
  expect("ours.exr theirs.exr --exact b --image-mde 0.2", 1, "taken for exact");  // it is not: it has noise
}

TEST_F(Compare, LayersAndGreyImages) {
  ExrImage layered = NoisyImage{.ours = false}.exr(), grey{32, 32, 0, 0, 32, 32, {}, {}};
  for (ExrChannel& channel : layered.channels) channel.name = "beauty." + channel.name;
  write("layered.exr", layered);
  expect("layered.exr layered.exr", 10, "the same image");  // so it was found
  ExrImage two = layered;
  for (const ExrChannel& channel : layered.channels)
    two.channels.push_back({"diffuse" + channel.name.substr(6), channel.pixels});
  write("two.exr", two);
  expect("two.exr layered.exr", 6, "choose one of its layers with --layer: beauty, diffuse");
  expect("two.exr layered.exr --layer beauty", 10, "the same image");
  expect("two.exr layered.exr --layer spec", 6, "it has no layer 'spec' with R, G, B");
  grey.channels.push_back({"Y", std::vector<float>(32 * 32, 0.5f)});
  write("grey.exr", grey);
  expect("grey.exr layered.exr --exact a", 8, "luminance");
}

TEST_F(Compare, UnfitImagesHaveAMessageAndACodeEach) {
  write("a.exr", NoisyImage{});
  write("small.exr", NoisyImage{.width = 16, .seed = 2});
  expect("a.exr small.exr", 5, "a.exr has 32 x 32 pixels and small.exr has 16 x 32");

  ExrImage no_blue = NoisyImage{.seed = 3, .ours = false}.exr();
  std::erase_if(no_blue.channels, [](const ExrChannel& c) { return c.name == "B"; });
  write("no_blue.exr", no_blue);
  expect("a.exr no_blue.exr", 6, "no_blue.exr: it has no channels R, G, B or Y; its channels are G, R");

  ExrImage nan = NoisyImage{.seed = 4}.exr();
  nan.channels[0].pixels[33] = std::numeric_limits<float>::quiet_NaN();
  nan.channels[0].pixels[77] = infinity;
  write("nan.exr", nan);
  expect("a.exr nan.exr", 7, "nan.exr: 2 values, NaN or infinite, the first at pixel 1,1");

  write("one.exr", NoisyImage{.seed = 5, .replicates = 1});
  expect("a.exr one.exr", 9, "one.exr: it was rendered with one replicate");

  write("same_seed.exr", NoisyImage{.mean = 0.6});
  expect("a.exr same_seed.exr", 10, "a.exr and same_seed.exr were both rendered with seed 1");
  write("copy1.exr", NoisyImage{.seed = 6, .ours = false});
  write("copy2.exr", NoisyImage{.seed = 6, .ours = false});
  expect("copy1.exr copy2.exr", 10, "copy1.exr and copy2.exr are the same image to the last bit");

  write("exact.exr", NoisyImage{.error = 0, .seed = 7});
  expect("exact.exr a.exr", 11, "exact.exr: its standard error is 0 in every pixel");
  expect("exact.exr a.exr --exact a", 0, "equal within noise");
}

TEST_F(Compare, BadArgumentsAreRefused) {
  write("a.exr", NoisyImage{});
  std::ofstream(path("text.exr")) << "no image";
  expect("a.exr", 2, "there is one image and nothing to compare it with");
  expect("a.exr none.exr", 2, "none.exr");
  expect("a.exr text.exr", 2, "text.exr: error: it is not an OpenEXR image");
  expect("-a a.exr", 2, "after -a and -b");
  expect("", 2, "give two images");
  expect("a.exr a.exr a.exr", 2, "give two images");
  write("b.exr", NoisyImage{.seed = 2});
  expect("a.exr b.exr --region x=0,0,64,1", 2, "reaches out of the image of 32x32 pixels");
  expect("a.exr b.exr --region 0,0,1,1", 2, "--region wants NAME=x0,y0,x1,y1");
  expect("a.exr b.exr --grid 3", 2, "--grid wants COLUMNSxROWS");
  expect("a.exr b.exr --image-mde nan", 2, "wants a number above 0");
  expect("a.exr b.exr --exact c", 2, "--exact");
  expect("a.exr b.exr --json none/out.json", 3, "there is no directory");
}

// Local against global light in a box that is white inside: the sum over all bounces is more than one of them.
TEST_F(Compare, ASceneUnderTwoIntegrators) {
  std::ofstream(path("box.toml")) << R"([camera]
position = [0, 0, 0.2]
look_at = [0, 1, 0]
[film]
width = 16
height = 16
[materials.white]
type = "matte"
reflectance = 0.5
[[shapes]]
type = "sphere"
material = "white"
center = [0, 0, 0]
radius = 1
emission = 1
two_sided = true
)";
  // One bounce of direct light: 1 + 0.5; all of them: 1/(1 − 0.5).
  const CommandResult result = compare(
      "box.toml --integrators blinn_phong,path --set blinn_phong.convention=physical --spp 16 "
      "--quiet --json out.json");
  EXPECT_EQ(result.exit_code, 1) << result.text;
  const nlohmann::json json = nlohmann::json::parse(std::ifstream(path("out.json")));
  const double change = json["image"]["change"], half_width = json["image"]["halfWidth95"];
  EXPECT_NEAR(change, 1.0 / 3, 2 * half_width);
  EXPECT_LT(half_width, 0.02);
  expect("box.toml --set path.max_depth=10,11 --spp 8 --image-mde 0.2 --tile-mde 0.2", 0,
         "equal within noise");
  expect("box.toml", 2, "there is nothing to compare: name two at least");
  expect("box.toml --samplers sobol,independent --integrators path,blinn_phong", 2,
         "a comparison is of two variants, and these are 4");
}

}  // namespace
}  // namespace umbral::test
