// Scenes that others wrote: they load as their users expect, or are refused with a located error.
#include <set>

#include "scene_folder.h"

namespace umbral {
namespace {

using test::contains;

struct Loaded {
  std::optional<SceneFile> file;
  std::string messages;
};

Loaded load(const std::filesystem::path& path) {
  test::StandInSettings settings;
  Loaded loaded;
  try {
    loaded.file = read_scene_file(path, test::stand_in_integrators(settings));
    for (const Diagnostic& warning : loaded.file->warnings) loaded.messages += warning.text() + '\n';
  } catch (const SceneError& error) {
    loaded.messages = error.what();
  }
  return loaded;
}

const Shape& shape_named(const SceneFile& file, const std::string& name) {
  for (const Shape& shape : file.scene.shapes)
    if (shape.name == name) return shape;
  throw std::runtime_error("there is no shape " + name);
}

template <class Lobe>
const Lobe& lobe_of(const SceneFile& file, const std::string& shape) {
  return std::get<Lobe>(file.scene.materials.at(index_of(shape_named(file, shape).material)).lobe);
}

TEST(SharedScenes, McGuiresCornellBoxes) {
  const auto folder = test::shared_scene("obj-cornell-box-mcguire");
  if (!folder) GTEST_SKIP() << test::no_shared_scenes;
  const Loaded original = load(*folder / "CornellBox-Original.obj");
  ASSERT_TRUE(original.file) << original.messages;
  EXPECT_EQ(original.file->scene.shapes.size(), 8u);
  EXPECT_EQ(shape_named(*original.file, "light").emission.value, rgb(17, 12, 4));
  EXPECT_FALSE(original.file->scene.environment);
  EXPECT_EQ(lobe_of<Lambert>(*original.file, "leftWall").reflectance, rgb(0.63f, 0.065f, 0.05f));

  const Loaded sphere = load(*folder / "CornellBox-Sphere.obj");
  ASSERT_TRUE(sphere.file) << sphere.messages;
  EXPECT_EQ(lobe_of<Mirror>(*sphere.file, "leftSphere").reflectance, grey(0.95f));
  EXPECT_EQ(lobe_of<Dielectric>(*sphere.file, "rightSphere").eta, 2.5f);
  EXPECT_FALSE(contains(sphere.messages, "is not closed")) << sphere.messages;

  const Loaded water = load(*folder / "CornellBox-Water.obj");
  ASSERT_TRUE(water.file) << water.messages;
  EXPECT_EQ(lobe_of<Dielectric>(*water.file, "water").eta, 1.33f);

  const Loaded glossy = load(*folder / "CornellBox-Glossy.obj");
  ASSERT_TRUE(glossy.file) << glossy.messages;
  EXPECT_EQ(lobe_of<BlinnPhong>(*glossy.file, "sphere").exponent, 40);
  EXPECT_TRUE(contains(glossy.messages, "kd + ks is 1.56")) << glossy.messages;
}

TEST(SharedScenes, EveryFileOfMcGuires) {
  const auto folder = test::shared_scene("obj-cornell-box-mcguire");
  if (!folder) GTEST_SKIP() << test::no_shared_scenes;
  int count = 0;
  for (const auto& entry : std::filesystem::directory_iterator(*folder)) {
    if (entry.path().extension() != ".obj") continue;
    const Loaded loaded = load(entry.path());
    EXPECT_TRUE(loaded.file) << loaded.messages;
    ++count;
  }
  EXPECT_EQ(count, 11);
}

TEST(SharedScenes, ScrubPineIsCutOutByTheAlphaOfItsColour) {
  const auto path = test::shared_scene("obj-scrub-pine-alpha/scrubPine.obj");
  if (!path) GTEST_SKIP() << test::no_shared_scenes;
  const Loaded pine = load(*path);
  ASSERT_TRUE(pine.file) << pine.messages;
  const SceneFile& file = *pine.file;
  const Material& leaves = file.scene.materials.at(index_of(shape_named(file, "SoftPine2").material));
  ASSERT_FALSE(leaves.alpha.is_constant());
  const Range opacity = file.scene.textures[index_of(leaves.alpha.map)].number_bounds();
  EXPECT_EQ(opacity.low, 0);
  EXPECT_EQ(opacity.high, 1);
  EXPECT_TRUE(file.scene.materials.at(index_of(shape_named(file, "SoftPineBark").material)).is_opaque());
  EXPECT_TRUE(contains(pine.messages, "opacity is the alpha of map_Kd")) << pine.messages;
}

TEST(SharedScenes, OddAndBrokenObjFilesLoadOrAreRefused) {
  const auto folder = test::shared_scene("robustness/tinyobj/models");
  if (!folder) GTEST_SKIP() << test::no_shared_scenes;
  // These have nothing that could be rendered: broken numbers, references to what is not there, no faces.
  const std::set<std::string> refused = {"catmark_torus_creases0.obj",
                                         "invalid-face-definition.obj",
                                         "invalid-relative-texture-index.obj",
                                         "invalid-relative-vertex-index.obj",
                                         "issue-140-zero-face-idx.obj",
                                         "issue-356-leading-spaces-newmtl.obj",
                                         "line-prim.obj",
                                         "points-prim.obj",
                                         "smoothing-group-two-squares.obj",
                                         "test-nan.obj"};
  int count = 0;
  for (const auto& entry : std::filesystem::directory_iterator(*folder)) {
    if (entry.path().extension() != ".obj") continue;
    const Loaded loaded = load(entry.path());
    EXPECT_NE(loaded.file.has_value(), refused.contains(entry.path().filename().string())) << loaded.messages;
    ++count;
  }
  EXPECT_EQ(count, 47);
}

TEST(SharedScenes, PlyFilesOfPbrtScenes) {
  int count = 0;
  for (const char* name : {"coffee-maker/models", "veach-ajar/models"}) {
    const auto folder = test::shared_scene(name);
    if (!folder) GTEST_SKIP() << test::no_shared_scenes;
    for (const auto& entry : std::filesystem::directory_iterator(*folder)) {
      if (entry.path().extension() != ".ply") continue;
      const Loaded loaded = load(entry.path());
      EXPECT_TRUE(loaded.file) << loaded.messages;
      ++count;
    }
  }
  EXPECT_GE(count, 20);
}

}  // namespace
}  // namespace umbral
