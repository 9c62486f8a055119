// Readers say which images they will ask for; these are decoded together, and nothing else comes of it.
#include <iterator>
#include <set>

#include "gltf_kit.h"
#include "image/png.h"

namespace umbral {
namespace {

using test::contains;
using test::SceneFolder;

constexpr const char* grey_texel = "P3 1 1 255\n128 128 128\n";

struct Progress {
  std::size_t done = 0, count = 0;
};

class ExpectedImages : public testing::Test {
 protected:
  ExpectedImages() {
    for (const char* name : {"a.ppm", "b.ppm", "c.ppm"}) folder_.write(name, grey_texel);
  }

  // How many images were decoded before they were asked for.
  Progress progress_of(const std::string& name, const ReadOptions& given = {}) const {
    Progress progress;
    ReadOptions options = given;
    options.on_images = [&](std::size_t done, std::size_t count) { progress = {done, count}; };
    test::StandInSettings settings;
    read_scene_file(folder_.path(name), test::stand_in_integrators(settings), options);
    return progress;
  }

  void expect_decoded(const std::string& name, std::size_t count, const ReadOptions& options = {}) const {
    const Progress progress = progress_of(name, options);
    EXPECT_EQ(progress.done, count) << name;
    EXPECT_EQ(progress.count, count) << name;
  }

  SceneFolder folder_;
};

constexpr const char* toml_scene = R"([textures.one]
type = "image"
file = "a.ppm"
[textures.tiles]
type = "image"
file = "t.<UDIM>.ppm"
color_space = "linear"
[materials.m]
type = "blinn_phong"
kd = "one"
ks = { type = "scale", texture = { type = "image", file = "a.ppm" }, scale = 0.5 }
ka = "tiles"
[[shapes]]
type = "sphere"
material = "m"
[[lights]]
type = "environment"
file = "b.ppm"
)";

TEST_F(ExpectedImages, OfTomlAreThoseOfTexturesTilesAndLights) {
  folder_.write("t.1001.ppm", grey_texel);
  folder_.write("t.1012.ppm", grey_texel);
  folder_.write("scene.toml", toml_scene);
  expect_decoded("scene.toml", 4);
  ReadOptions options;
  options.environment = folder_.path("c.ppm").string();
  expect_decoded("scene.toml", 5, options);
}

// Colours, the numbers for which the same file is decoded anew, and what lies within the file; not what no shape shows.
TEST_F(ExpectedImages, OfGltfAreThoseOfMaterialsInUse) {
  const test::GltfSquare square;
  folder_.write("t.tga", test::tga(1, 1, 0, 255, 0, 255));
  write_png(folder_.path("red.png").string(), 1, 1, std::vector<Spectrum>{Spectrum(1, 0, 0, 1)});
  std::ifstream red(folder_.path("red.png"), std::ios::binary);
  const std::string inner =
      "data:image/png;base64," + test::base64({std::istreambuf_iterator<char>(red), {}});
  const std::string looks =
      R"(, "images": [{"uri": "t.tga"}, {"uri": ")" + inner + R"("}, {"uri": "none.tga"}],
    "textures": [{"source": 0}, {"source": 1}, {"source": 2}],
    "materials": [{"pbrMetallicRoughness": {"baseColorTexture": {"index": 0}, "metallicRoughnessTexture": {"index": 0}},
                   "emissiveFactor": [1, 1, 1], "emissiveTexture": {"index": 1}},
                  {"normalTexture": {"index": 2}}])";
  folder_.write("scene.gltf", square.file(R"({"mesh": 0})", 1, looks, R"(, "material": 0)"));
  expect_decoded("scene.gltf", 3);
  const SceneFile file = folder_.read("scene.gltf");
  const TextureId shown = file.scene.shapes.at(0).emission.map;
  EXPECT_EQ(file.scene.textures.at(index_of(shown)).color({0.5f, 0.5f}), Spectrum(1, 0, 0, 1));
}

TEST_F(ExpectedImages, OfObjAreThoseOfItsMaterials) {
  folder_.write("scene.mtl", "newmtl m\nKd 1 1 1\nmap_Kd a.ppm\nmap_d b.ppm\nnewmtl unused\nmap_Kd c.ppm\n");
  folder_.write("scene.obj", "mtllib scene.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nusemtl m\nf 1 2 3\n");
  expect_decoded("scene.obj", 2);
}

TEST_F(ExpectedImages, OfPbrtAreItsImageMaps) {
  folder_.write(
      "scene.pbrt",
      "WorldBegin\nTexture \"t\" \"spectrum\" \"imagemap\" \"string filename\" \"a.ppm\"\n"
      "Texture \"u\" \"float\" \"imagemap\" \"string filename\" \"b.ppm\" \"string encoding\" \"linear\"\n"
      "Material \"diffuse\" \"texture reflectance\" \"t\"\nShape \"sphere\" \"texture alpha\" \"u\"\n");
  expect_decoded("scene.pbrt", 2);
}

TEST_F(ExpectedImages, OfMitsubaAreItsBitmapsAndEnvironment) {
  folder_.write("scene.xml",
                "<scene version='3.0.0'><shape type='sphere'><bsdf type='diffuse'><texture type='bitmap' "
                "name='reflectance'><string name='filename' value='a.ppm'/></texture></bsdf></shape>"
                "<emitter type='envmap'><string name='filename' value='b.ppm'/></emitter></scene>");
  expect_decoded("scene.xml", 2);
}

// One texel takes four bytes, and seven eighths of the memory are for images that are whole: two of three are.
TEST_F(ExpectedImages, TakeNoMoreThanTheMemoryOfTexturesHolds) {
  folder_.write("t.1001.ppm", grey_texel);
  folder_.write("scene.toml", toml_scene);
  ReadOptions options;
  options.texture_memory = 10;
  test::StandInSettings settings;
  const SceneFile file =
      read_scene_file(folder_.path("scene.toml"), test::stand_in_integrators(settings), options);
  std::set<const TextureImage*> whole{file.scene.environment->image.get()};
  for (const Texture& texture : file.scene.textures)
    if (const auto* image = std::get_if<ImageTexture>(&texture.kind)) whole.insert(image->image.get());
  EXPECT_EQ(whole.size(), 3u);
  EXPECT_EQ(std::erase_if(whole, [](const TextureImage* image) { return image->memory() == 0; }), 1u);
}

TEST_F(ExpectedImages, ThatAreBrokenAreToldInTheOrderOfTheFile) {
  folder_.write("b.ppm", "P3 1 1 255\n");
  folder_.write(
      "scene.toml",
      "[textures.z]\ntype = \"image\"\nfile = \"none.ppm\"\n[textures.a]\ntype = \"image\"\nfile = "
      "\"b.ppm\"\n"
      "[materials.m]\ntype = \"blinn_phong\"\nkd = \"a\"\nks = \"z\"\n[[shapes]]\ntype = \"sphere\"\n"
      "material = \"m\"\n");
  const std::string errors = folder_.errors("scene.toml");
  const std::size_t first = errors.find("scene.toml:3:"), second = errors.find("scene.toml:6:");
  ASSERT_NE(first, std::string::npos) << errors;
  ASSERT_NE(second, std::string::npos) << errors;
  EXPECT_LT(first, second) << errors;
  EXPECT_TRUE(contains(errors, "none.ppm: cannot be read")) << errors;
  EXPECT_TRUE(contains(errors, "the image is damaged")) << errors;
}

}  // namespace
}  // namespace umbral
