// Materials: textures replace the parameters they were put on, and nothing else.
#include "scene/material.h"

#include <gtest/gtest.h>

#include "core/kinds.h"
#include "support/scene_kit.h"

namespace umbral {
namespace {

using test::add_material, test::add_texture;

// A different colour left and right of u = 1/2.
CheckerTexture halves(const Spectrum& left, const Spectrum& right) {
  CheckerTexture checker;
  checker.even = left;
  checker.odd = right;
  checker.uv_scale = {2, 0};
  checker.channel = TextureChannel::g;
  return checker;
}

constexpr Vec2 left{0.25f, 0.5f}, right{0.75f, 0.5f};

TEST(Material, KeepsConstantsWithoutTextures) {
  Material material{"", BlinnPhong{rgb(0.1f, 0.2f, 0.3f), grey(0.4f), 50}, {}, {1}};
  const auto lobe = std::get<BlinnPhong>(material.at(left, {}));
  EXPECT_EQ(lobe.kd, rgb(0.1f, 0.2f, 0.3f));
  EXPECT_EQ(lobe.ks, grey(0.4f));
  EXPECT_EQ(lobe.exponent, 50);
}

TEST(Material, PutsEachTextureOnItsOwnParameter) {
  SceneDescription scene;
  const TextureId color = add_texture(scene, halves(rgb(1, 0, 0), rgb(0, 0.5f, 0)));
  const TextureId number = add_texture(scene, halves(rgb(0, 10, 0), rgb(0, 200, 0)));
  add_material(scene, BlinnPhong{grey(0.9f), grey(0.3f), 50, grey(0.2f)},
               {{"kd", color}, {"exponent", number}});
  const Material& material = scene.materials[0];
  ASSERT_EQ(material.maps.size(), 2u);
  for (const auto& [uv, kd, exponent] :
       {std::tuple{left, rgb(1, 0, 0), 10.0f}, std::tuple{right, rgb(0, 0.5f, 0), 200.0f}}) {
    const auto lobe = std::get<BlinnPhong>(material.at(uv, scene.textures));
    EXPECT_EQ(lobe.kd, kd);
    EXPECT_EQ(lobe.exponent, exponent);
    EXPECT_EQ(lobe.ks, grey(0.3f));
    EXPECT_EQ(lobe.ka, grey(0.2f));
  }
}

// Every parameter of every lobe takes a texture, and only that parameter follows it.
TEST(Material, TexturesAnyParameterOfAnyLobe) {
  for_each_kind<Lobes>([](const auto& prototype) {
    using Lobe = std::remove_cvref_t<decltype(prototype)>;
    for_each_parameter(prototype, [](const ParameterInfo& info, const auto& value) {
      if (std::is_enum_v<std::remove_cvref_t<decltype(value)>>) return;
      SCOPED_TRACE(std::string(Lobe::kind) + "." + info.name);
      SceneDescription scene;
      const TextureId map = add_texture(scene, halves(rgb(0.25f, 0.5f, 0.125f), rgb(0.75f, 0.375f, 0.625f)));
      add_material(scene, Lobe{}, {{info.name, map}});
      const Lobe plain;
      const auto textured = std::get<Lobe>(scene.materials[0].at(right, scene.textures));
      const auto check = [&](const ParameterInfo& other, const auto& before, const auto& after) {
        if (std::string(other.name) != info.name) {
          EXPECT_EQ(before, after) << other.name;
        } else if constexpr (std::is_same_v<std::remove_cvref_t<decltype(before)>, float>) {
          EXPECT_EQ(after, 0.375f);
        } else if constexpr (std::is_same_v<std::remove_cvref_t<decltype(before)>, Spectrum>) {
          EXPECT_EQ(after, rgb(0.75f, 0.375f, 0.625f));
        }
      };
      std::apply([&](const auto&... p) { (check(p.info, plain.*(p.member), textured.*(p.member)), ...); },
                 Lobe::parameters);
    });
  });
}

// A coat over a mix: what any of them has from a texture is seen at the point, and what none has is the material's own.
TEST(Material, MadeOfOthersFollowsTheirTextures) {
  SceneDescription scene;
  const TextureId map = add_texture(scene, halves(grey(0.25f), grey(0.75f)));
  add_material(scene, Lambert{}, {{"reflectance", map}});
  add_material(scene, Conductor{});
  const auto join = [&](Lobes lobe, const std::vector<MaterialPart>& parts) {
    add_material(scene, lobe);
    scene.materials.back().parts = parts;
    return static_cast<MaterialId>(scene.materials.size() - 1);
  };
  using detail::set_part;
  const MaterialId mix =
      join(Mix{}, {{set_part<&Mix::a>, MaterialId{0}}, {set_part<&Mix::b>, MaterialId{1}}});
  const MaterialId coat = join(Coat{}, {{set_part<&Coat::base>, mix}});
  const MaterialId plain = join(Coat{}, {{set_part<&Coat::base>, MaterialId{1}}});
  join_parts(scene.materials);
  const auto material = [&](MaterialId id) -> const Material& { return scene.materials[index_of(id)]; };
  EXPECT_TRUE(material(mix).varies && material(coat).varies);
  EXPECT_FALSE(material(plain).varies);
  EXPECT_EQ(std::get<Coat>(material(plain).lobe).base, &scene.materials[1].lobe);
  LobeStack stack;
  for (const auto& [uv, reflectance] : {std::pair{left, 0.25f}, {right, 0.75f}}) {
    stack.clear();
    const Lobes& lobe =
        varying_lobe(material(coat), scene.materials, TexturePoint{uv}, scene.textures, stack);
    const Mix& mixed = std::get<Mix>(*std::get<Coat>(lobe).base);
    EXPECT_EQ(std::get<Lambert>(*mixed.a).reflectance, grey(reflectance));
    EXPECT_EQ(mixed.b, &scene.materials[1].lobe) << "what does not vary is not copied";
  }
}

TEST(Material, TakesNoAlphaFromAColoursTexture) {
  SceneDescription scene;
  ImageTexture image;
  TexelGrid<Float4> grid(1, 1);
  grid.set(0, 0, {0.1f, 0.2f, 0.3f, 0.9f});
  image.image = std::make_shared<TextureImage>(TextureImage::Texels(std::move(grid)));
  add_material(scene, Lambert{}, {{"reflectance", add_texture(scene, image)}});
  EXPECT_EQ(std::get<Lambert>(scene.materials[0].at(left, scene.textures)).reflectance,
            rgb(0.1f, 0.2f, 0.3f));
}

TEST(Material, IsOpaqueUnlessItsAlphaSaysOtherwise) {
  SceneDescription scene;
  const TextureId map = add_texture(scene, halves(grey(0), grey(1)));
  add_material(scene, Lambert{});
  add_material(scene, Lambert{}, {{"alpha", map}});
  EXPECT_TRUE(scene.materials[0].is_opaque());
  EXPECT_FALSE(scene.materials[1].is_opaque());
  EXPECT_EQ(scene.materials[1].alpha.map, map);
  EXPECT_TRUE(scene.materials[1].maps.empty()) << "alpha is the material's, not the lobe's";
  scene.materials[0].alpha.value = 0.5f;
  EXPECT_FALSE(scene.materials[0].is_opaque());
}

}  // namespace
}  // namespace umbral
