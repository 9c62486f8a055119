// What the documents show as a scene is one that can be read.
#include <fstream>
#include <regex>

#include <gtest/gtest.h>

#include "app/load_scene.h"
#include "support/contents.h"
#include "support/paths.h"

namespace umbral::test {
namespace {

// The blocks of TOML with a camera are whole scenes; the others are parts.
std::vector<std::string> whole_scenes(const std::string& text) {
  static const std::regex block(R"(```toml\n([^`]*)```)");
  std::vector<std::string> scenes;
  for (auto match = std::sregex_iterator(text.begin(), text.end(), block); match != std::sregex_iterator();
       ++match)
    if ((*match)[1].str().starts_with("[camera]")) scenes.push_back((*match)[1]);
  return scenes;
}

class DocumentedScene : public testing::TestWithParam<const char*> {};
INSTANTIATE_TEST_SUITE_P(Documents, DocumentedScene, testing::Values("README.md", "docs/scene-file.md"),
                         [](const auto& tested) {
                           const std::filesystem::path path(tested.param);
                           return std::regex_replace(path.stem().string(), std::regex("-"), "_");
                         });

TEST_P(DocumentedScene, IsReadWithoutAWordOfWarning) {
  const TemporaryDirectory folder;
  const std::vector<std::string> scenes = whole_scenes(contents(source_path(GetParam())));
  ASSERT_EQ(scenes.size(), 1u);
  const std::filesystem::path file = folder.path() / "scene.toml";
  std::ofstream(file) << scenes.front();
  const LoadedScene loaded = load_scene(file.string());
  EXPECT_TRUE(loaded.file.warnings.empty());
  EXPECT_FALSE(loaded.file.scene.shapes.empty());
}

}  // namespace
}  // namespace umbral::test
