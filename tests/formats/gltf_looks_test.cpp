// What textures and cameras of glTF become beyond the usual.
#include "gltf_kit.h"

namespace umbral {
namespace {

using test::contains;
using test::GltfSquare;

struct GltfLooks : testing::Test {
  test::SceneFolder folder;

  SceneFile read(const std::string& text) const {
    folder.write("a.gltf", text);
    return folder.read("a.gltf");
  }
  SceneFile painted(const std::string& sampler, const std::string& material) const {
    const GltfSquare square;
    folder.write("t.tga", test::tga(2, 2, 128, 255, 64, 255));
    return read(square.file(R"({"mesh": 0})", 1,
                            R"(, "images": [{"uri": "t.tga"}], "textures": [{"source": 0, "sampler": 0}],
                                "samplers": [)" +
                                sampler + R"(], "materials": [)" + material + R"(],
                                "extensionsUsed": ["KHR_materials_anisotropy", "KHR_materials_clearcoat",
                                                   "KHR_texture_transform"])",
                            R"(, "material": 0)"));
  }
};

TEST_F(GltfLooks, TexturesWrapInSAndInTAsTheirSamplerSays) {
  const char* material = R"({"pbrMetallicRoughness": {"baseColorTexture": {"index": 0}}})";
  const auto wraps = [&](const char* sampler) {
    const SceneFile file = painted(sampler, material);
    EXPECT_FALSE(contains(folder.warnings(file), "wrap"));
    return std::get<ImageTexture>(file.scene.textures.at(0).kind).wraps();
  };
  EXPECT_EQ(wraps(R"({"wrapS": 33071})").u, Wrap::clamp);
  EXPECT_EQ(wraps(R"({"wrapS": 33071})").v, Wrap::repeat);
  EXPECT_EQ(wraps(R"({"wrapT": 33648})").u, Wrap::repeat);
  EXPECT_EQ(wraps(R"({"wrapT": 33648})").v, Wrap::mirror);
  EXPECT_EQ(wraps(R"({"wrapS": 33648, "wrapT": 33648})").v, Wrap::mirror);
}

// Red 128 is along u by nothing, green 255 along v by 1: 90°, and the rotation on top.
TEST_F(GltfLooks, AnisotropyHasTheDirectionsOfItsTexture) {
  const SceneFile file =
      painted("{}", R"({"extensions": {"KHR_materials_anisotropy": {"anisotropyStrength": 0.8,
      "anisotropyRotation": 0.5235988, "anisotropyTexture": {"index": 0}}}})");
  const Material& material = file.scene.materials.at(index_of(file.scene.shapes.at(0).material));
  const auto lobe = std::get<Principled>(material.at({0.5f, 0.5f}, file.scene.textures));
  EXPECT_NEAR(lobe.anisotropy_rotation, 120, 0.3);
  EXPECT_NEAR(lobe.anisotropy, 0.8 * 64 / 255, 1e-4);
  const SceneFile plain =
      painted("{}", R"({"extensions": {"KHR_materials_anisotropy": {"anisotropyStrength": 0.8,
      "anisotropyRotation": -0.5235988}}})");
  EXPECT_NEAR(std::get<Principled>(plain.scene.materials.at(0).lobe).anisotropy_rotation, 330, 1e-3);
}

// By the text of KHR_materials_clearcoat the coat has its own normal texture or none, whatever the base has.
TEST_F(GltfLooks, ClearcoatsHaveTheirOwnNormals) {
  const auto read_material = [&](const std::string& normals, const std::string& of_coat) {
    const SceneFile file = painted("{}", "{" + normals + R"("extensions": {"KHR_materials_clearcoat":
        {)" + of_coat + "}}}");
    EXPECT_EQ(folder.warnings(file).find("learcoat"), std::string::npos) << folder.warnings(file);
    EXPECT_FALSE(file.scene.textures.size() > 2);
    const Material material = file.scene.materials.at(0);
    if (material.has_clearcoat_normal_map()) {
      const Texture& map = file.scene.textures.at(index_of(material.clearcoat_normal_map.map));
      EXPECT_FALSE(std::get<ImageTexture>(map.kind).image->is_srgb());
    }
    return material;
  };
  const std::string base = R"("normalTexture": {"index": 0, "scale": 0.3}, )";
  const std::string half = R"("clearcoatFactor": 0.5)";
  const auto with_map = [&](const std::string& rest) {
    return half + R"(, "clearcoatNormalTexture": {"index": 0, )" + rest + "}";
  };
  const Material own = read_material("", with_map(R"("scale": 0.7)"));
  EXPECT_FALSE(own.has_normal_map());
  EXPECT_TRUE(own.has_clearcoat_normal());
  EXPECT_FLOAT_EQ(own.clearcoat_normal_scale, 0.7f);

  const Material flat = read_material(base, half);
  EXPECT_TRUE(flat.has_normal_map());
  EXPECT_FALSE(flat.has_clearcoat_normal_map());
  EXPECT_TRUE(flat.has_clearcoat_normal());

  const Material shared = read_material(base, with_map(R"("scale": 0.3)"));
  EXPECT_EQ(shared.clearcoat_normal_map, shared.normal_map);
  EXPECT_FALSE(shared.has_clearcoat_normal()) << "the same normals are not worked out twice";
  for (const char* other :
       {R"("scale": 0.4)", R"("scale": 0.3, "extensions": {"KHR_texture_transform": {"scale": [2, 2]}})",
        R"("scale": 0.3, "texCoord": 1)"})
    EXPECT_TRUE(read_material(base, with_map(other)).has_clearcoat_normal()) << other;

  EXPECT_FALSE(read_material(base, R"("clearcoatFactor": 0)").has_clearcoat_normal()) << "there is no coat";
}

TEST_F(GltfLooks, OrthographicCamerasAreAsHighAsTheySay) {
  const GltfSquare square;
  const auto camera = [&](const std::string& lens) {
    return read(square.file(R"({"mesh": 0}, {"camera": 0, "translation": [0, 0, 5]})", 2,
                            R"(, "cameras": [{"type": "orthographic", "orthographic": )" + lens + "}]"));
  };
  const SceneFile file = camera(R"({"xmag": 3, "ymag": 1.5, "znear": 0.1, "zfar": 100})");
  EXPECT_EQ(file.scene.camera.orthographic_height, 3);
  EXPECT_EQ(file.scene.camera.position, Vec3(0, 0, 5));
  EXPECT_NEAR(static_cast<double>(file.film.width) / file.film.height, 2, 0.01);
}

TEST_F(GltfLooks, WhatEmitsNoMoreThanOneIsALabelNotALamp) {
  const auto has_sky = [&](const std::string& material) {
    const GltfSquare square;
    const SceneFile file =
        read(square.file(R"({"mesh": 0})", 1, R"(, "materials": [)" + material + R"(], "extensionsUsed":
          ["KHR_materials_unlit", "KHR_materials_emissive_strength"])",
                         R"(, "material": 0)"));
    EXPECT_TRUE(file.scene.shapes.at(0).emits());
    return file.scene.environment.has_value();
  };
  EXPECT_TRUE(has_sky(R"({"emissiveFactor": [0, 1, 0]})"));
  EXPECT_TRUE(has_sky(R"({"extensions": {"KHR_materials_unlit": {}}})"));
  EXPECT_FALSE(has_sky(R"({"emissiveFactor": [0, 1, 0], "extensions": {"KHR_materials_emissive_strength":
      {"emissiveStrength": 4}}})"));
}

}  // namespace
}  // namespace umbral
