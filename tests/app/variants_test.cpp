// Lists of alternatives become variants with the settings asked for, under names that tell them apart.
#include "app/variants.h"

#include <fstream>

#include <gtest/gtest.h>

#include "core/error.h"
#include "integrators/path.h"
#include "support/paths.h"

namespace umbral {
namespace {

class Variants : public testing::Test {
 protected:
  Variants() {
    const std::string path = (directory_.path() / "scene.toml").string();
    std::ofstream(path) << R"([camera]
position = [0, 0, 3]
look_at = [0, 0, 0]
[film]
width = 8
height = 8
[integrator.path]
max_depth = 5
strategy = "bsdf"
[materials.wall]
type = "matte"
[[shapes]]
type = "sphere"
material = "wall"
)";
    scene_ = load_scene(path);
  }

  std::vector<std::string> names(const VariantArguments& arguments) const {
    std::vector<std::string> result;
    for (const Variant& variant : variants(scene_, arguments)) result.push_back(variant.name);
    return result;
  }

  std::string refusal(const VariantArguments& arguments) const {
    try {
      variants(scene_, arguments);
    } catch (const SceneError& error) {
      return error.what();
    }
    return {};
  }

  test::TemporaryDirectory directory_;
  LoadedScene scene_;
};

using Names = std::vector<std::string>;

TEST_F(Variants, WithoutListsThereIsTheSceneAsItIs) {
  const std::vector<Variant> all = variants(scene_, {});
  ASSERT_EQ(all.size(), 1u);
  EXPECT_EQ(all[0].name, "path");
  EXPECT_EQ(all[0].call,
            "path(max_depth = 5, strategy = \"bsdf\", roulette_depth = 3, light_choice = \"tree\")");
  EXPECT_THROW(require_several(all), SceneError);
}

TEST_F(Variants, ListsAreCombined) {
  EXPECT_EQ(names({{"path", "blinn_phong"}, {}, {}}), (Names{"path", "blinn_phong"}));
  EXPECT_EQ(names({{}, {"sobol", "independent"}, {"path.strategy=mis,light"}}),
            (Names{"sobol strategy=mis", "sobol strategy=light", "independent strategy=mis",
                   "independent strategy=light"}));
}

TEST_F(Variants, ASettingOfAnIntegratorIsThatIntegratorsAlone) {
  EXPECT_EQ(names({{"path", "normals"}, {}, {"path.strategy=mis,light", "sampling.replicates=1"}}),
            (Names{"path strategy=mis", "path strategy=light", "normals"}));
}

TEST_F(Variants, HoldWhatWasSetAndOtherwiseWhatTheFileSays) {
  const std::vector<Variant> all =
      variants(scene_, {{}, {}, {"path.strategy=mis,light", "sampling.replicates=1,4", "film.filter=box"}});
  ASSERT_EQ(all.size(), 4u);
  const auto& second = dynamic_cast<const PathIntegrator&>(*all[1].integrator);
  EXPECT_EQ(second.strategy, Strategy::mis);
  EXPECT_EQ(second.max_depth, 5);
  EXPECT_EQ(all[1].sampling.replicates, 4);
  EXPECT_EQ(all[1].film.filter, FilterKind::box);
  EXPECT_EQ(all[1].name, "strategy=mis replicates=4");
  EXPECT_EQ(dynamic_cast<const PathIntegrator&>(*all[2].integrator).strategy, Strategy::light);
}

TEST_F(Variants, WhatCannotBeIsRefusedWithItsReason) {
  const auto has = [](const std::string& text, const std::string& part) {
    EXPECT_NE(text.find(part), std::string::npos) << text;
  };
  has(refusal({{"pth"}, {}, {}}), "there is no integrator 'pth'; did you mean 'path'?");
  has(refusal({{}, {"sobl"}, {}}), "there is no sampler 'sobl'; did you mean 'sobol'?");
  has(refusal({{}, {}, {"path.strategi=mis"}}),
      "'strategi' is not a parameter of 'path'; did you mean 'strategy'?");
  has(refusal({{}, {}, {"path.strategy=mix"}}), "'strategy' of 'path' cannot be 'mix'");
  has(refusal({{}, {}, {"path.max_depth=-1"}}), "'max_depth' of 'path' is -1 but must be");
  has(refusal({{}, {}, {"path.max_depth=1,,2"}}), "a value is missing");
  has(refusal({{}, {}, {"strategy=mis"}}), "--set wants OWNER.NAME=VALUE");
  has(refusal({{}, {}, {"normals.x=1"}}),
      "there is no owner of settings among these variants called 'normals'");
  has(refusal({{}, {}, {"film.width=8,16"}}), "must have the same size");
  has(refusal({{"path", "path"}, {}, {}}), "'path' is asked for twice");
}

}  // namespace
}  // namespace umbral
