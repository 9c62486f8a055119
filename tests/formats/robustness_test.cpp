// Broken input never crashes: it loads or is refused with located errors.
#include <random>

#include "samples.h"
#include "scene_folder.h"

namespace umbral {
namespace {

using test::Sample;
using test::samples;
using test::SceneFolder;

struct FolderWithAll : SceneFolder {
  FolderWithAll() {
    for (const Sample& sample : samples()) write(sample.file, sample.bytes);
  }
};

// True if the file loads; errors that are not SceneError, or have no message or file, fail the test.
bool loads(const SceneFolder& folder, const std::string& name) {
  try {
    folder.read(name);
    return true;
  } catch (const SceneError& error) {
    EXPECT_FALSE(error.diagnostics().empty());
    for (const Diagnostic& diagnostic : error.diagnostics()) {
      EXPECT_FALSE(diagnostic.message.empty());
      EXPECT_FALSE(diagnostic.where.file.empty());
    }
  }
  return false;
}

TEST(BrokenFiles, TheSamplesLoadWhole) {
  const FolderWithAll folder;
  for (const Sample& sample : samples())
    EXPECT_TRUE(loads(folder, sample.scene)) << folder.errors(sample.scene);
}

TEST(BrokenFiles, CutAnywhere) {
  const FolderWithAll folder;
  for (const Sample& sample : samples()) {
    int refused = 0;
    for (std::size_t size = 0; size < sample.bytes.size(); ++size) {
      folder.write(sample.file, sample.bytes.substr(0, size));
      refused += loads(folder, sample.scene) ? 0 : 1;
    }
    // A cut texture leaves the material's constant, as a missing one does.
    if (!std::string_view(sample.file).starts_with("t.")) {
      EXPECT_GT(refused, 10) << sample.file;
    }
    folder.write(sample.file, sample.bytes);
  }
}

TEST(BrokenFiles, WithBytesChangedAtRandom) {
  const FolderWithAll folder;
  std::mt19937 random(1);
  const std::string alphabet = "0123456789.-+eE/\\#[]{}=\"\n\r\t vtnfx\xff";
  for (const Sample& sample : samples()) {
    for (int trial = 0; trial < 400; ++trial) {
      std::string bytes = sample.bytes;
      for (int changes = 1 + trial % 4; changes > 0; --changes) {
        const std::size_t at = random() % bytes.size();
        bytes[at] = trial % 2 == 0 ? static_cast<char>(random()) : alphabet[random() % alphabet.size()];
      }
      folder.write(sample.file, bytes);
      loads(folder, sample.scene);
    }
    folder.write(sample.file, sample.bytes);
  }
}

// Numbers, names and brackets of the JSON are exchanged for others, so that it stays JSON more often than by chance.
TEST(BrokenFiles, GltfWithValuesExchanged) {
  const FolderWithAll folder;
  const std::string text =
      test::gltf(test::gltf_square().bytes.bytes(), test::gltf_square().parts + test::gltf_rest);
  const std::size_t begin = text.find("bufferViews");
  std::mt19937 random(1);
  const std::vector<std::string> values{"0",  "1",  "-1",   "4294967295", "1e300", "2.5",
                                        "{}", "[]", "null", "\"\"",       "true"};
  int loaded = 0;
  for (int trial = 0; trial < 1500; ++trial) {
    std::string changed = text;
    const std::size_t at = begin + random() % (text.size() - begin);
    const std::size_t digit = changed.find_first_of("0123456789", at);
    if (digit == std::string::npos) continue;
    const std::size_t end = changed.find_first_not_of("0123456789.", digit);
    changed.replace(digit, end - digit, values[random() % values.size()]);
    folder.write("a.gltf", changed);
    loaded += loads(folder, "a.gltf") ? 1 : 0;
  }
  EXPECT_GT(loaded, 150);
  EXPECT_LT(loaded, 1350);
}

TEST(BrokenFiles, SharedGltfFilesCutAnywhere) {
  const auto folder = test::shared_scene("gltf-structure");
  if (!folder) GTEST_SKIP() << test::no_shared_scenes;
  const SceneFolder own;
  for (const char* file :
       {"BoxInterleaved/glTF/BoxInterleaved.gltf", "SimpleSparseAccessor/glTF/SimpleSparseAccessor.gltf"}) {
    std::filesystem::create_directories(own.path("x"));
    for (const auto& beside : std::filesystem::directory_iterator((*folder / file).parent_path()))
      std::filesystem::copy_file(beside.path(), own.path(beside.path().filename()),
                                 std::filesystem::copy_options::overwrite_existing);
    std::ifstream in(*folder / file, std::ios::binary);
    const std::string bytes((std::istreambuf_iterator<char>(in)), {});
    EXPECT_TRUE(loads(own, std::filesystem::path(file).filename()));
    for (std::size_t size = 0; size + 10 < bytes.size(); size += 10) {
      own.write("cut.gltf", bytes.substr(0, size));
      EXPECT_FALSE(loads(own, "cut.gltf")) << size;
    }
  }
}

// Inputs that once broke a reader, of the kind that their ending names.
TEST(BrokenFiles, FoundByFuzzing) {
  int count = 0;
  for (const auto& finding :
       std::filesystem::directory_iterator(test::source_path("tests/formats/findings"))) {
    SCOPED_TRACE(finding.path().filename());
    const FolderWithAll folder;
    const Sample kind = test::sample_of(finding.path().extension().string().substr(1));
    std::ifstream in(finding.path(), std::ios::binary);
    folder.write(kind.file, std::string((std::istreambuf_iterator<char>(in)), {}));
    loads(folder, kind.scene);
    ++count;
  }
  EXPECT_GT(count, 0);
}

TEST(BrokenFiles, ThatAreNoFilesAreNamed) {
  const SceneFolder folder;
  std::filesystem::create_directory(folder.path("folder.toml"));
  EXPECT_EQ(folder.errors("folder.toml"),
            "folder.toml: error: it is a directory, and no file in it has the name of a scene");
  std::filesystem::create_symlink("/dev/zero", folder.path("zero.obj"));
  EXPECT_EQ(folder.errors("zero.obj"), "zero.obj: error: cannot be read: it is a device");
  std::filesystem::create_symlink("loop.ply", folder.path("loop.ply"));
  EXPECT_EQ(folder.errors("loop.ply"), "loop.ply: error: cannot be read: Too many levels of symbolic links");
}

TEST(BrokenFiles, DeepNestingIsRefused) {
  const SceneFolder folder;
  EXPECT_NE(folder.errors_of_toml("x = " + std::string(100000, '[')), "no error");
}

}  // namespace
}  // namespace umbral
