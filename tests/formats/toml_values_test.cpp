// Every parameter of everything described comes back from a TOML file as it was written.
#include "core/kinds.h"
#include "parameter_filling.h"
#include "scene_folder.h"

namespace umbral {
namespace {

using test::dump;
using test::Filled;
using test::SceneFolder;

constexpr const char* triangle_ply =
    "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\n"
    "element face 1\nproperty list uchar int vertex_indices\nend_header\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n";

constexpr const char* environment = "[[lights]]\ntype = \"environment\"\n";

struct FolderWithFiles : SceneFolder {
  FolderWithFiles() {
    write("texture.tga", test::tga(2, 2, 0, 0, 0, 255));
    write("lamp.tga", test::tga(2, 2, 200, 150, 100, 255));
    write("triangle.ply", triangle_ply);
  }
};

TEST(TomlValues, CameraFilmAndSampling) {
  const SceneFolder folder;
  const Filled<CameraSettings> camera;
  const Filled<FilmSettings> film;
  const Filled<SamplingSettings> sampling;
  const SceneFile file = folder.read_toml("[camera]\n" + camera.toml + "[film]\n" + film.toml +
                                          "[sampling]\n" + sampling.toml + environment);
  EXPECT_EQ(dump(file.scene.camera), dump(camera.value));
  EXPECT_EQ(dump(file.film), dump(film.value));
  EXPECT_EQ(dump(file.sampling), dump(sampling.value));
  EXPECT_NE(dump(file.scene.camera), dump(CameraSettings{}));
  EXPECT_EQ(file.sampling.seed, 9007199254740993u);
}

TEST(TomlValues, ShapesOfEveryKind) {
  for_each_kind<ShapeKinds>([](auto&& start) {
    using Kind = std::decay_t<decltype(start)>;
    const FolderWithFiles folder;
    const Filled<Kind> shape(start, "triangle.ply");
    const SceneFile file =
        folder.read_toml(std::string("[materials.m]\ntype = \"matte\"\n[[shapes]]\ntype = \"") + Kind::kind +
                         "\"\nname = \"thing\"\nmaterial = \"m\"\n" + shape.toml);
    ASSERT_EQ(file.scene.shapes.size(), 1u) << Kind::kind;
    EXPECT_EQ(dump(std::get<Kind>(file.scene.shapes[0].kind)), dump(shape.value)) << Kind::kind;
    EXPECT_EQ(file.scene.shapes[0].name, "thing");
  });
}

TEST(TomlValues, LightsOfEveryKind) {
  for_each_kind<LightKinds>([](auto&& start) {
    using Kind = std::decay_t<decltype(start)>;
    const FolderWithFiles folder;
    const Filled<Kind> light(start, "lamp.tga");
    const SceneFile file = folder.read_toml(std::string("[[lights]]\ntype = \"") + Kind::kind + "\"\n" +
                                            light.toml + environment);
    ASSERT_EQ(file.scene.lights.size(), 1u) << Kind::kind;
    EXPECT_EQ(dump(std::get<Kind>(file.scene.lights[0])), dump(light.value)) << Kind::kind;
  });
}

TEST(TomlValues, Environment) {
  const FolderWithFiles folder;
  const Filled<EnvironmentLight> light({}, "lamp.tga");
  const SceneFile file = folder.read_toml(environment + light.toml);
  ASSERT_TRUE(file.scene.environment);
  EXPECT_EQ(dump(*file.scene.environment), dump(light.value));
  ASSERT_TRUE(file.scene.environment->image);
  EXPECT_EQ(file.scene.environment->image->width(), 2);
}

TEST(TomlValues, TexturesOfEveryKind) {
  for_each_kind<TextureKinds>([](auto&& start) {
    using Kind = std::decay_t<decltype(start)>;
    const FolderWithFiles folder;
    const Filled<Kind> texture(start, "texture.tga");
    const SceneFile file = folder.read_toml(std::string("[[shapes]]\ntype = \"sphere\"\nemission = \"t\"\n") +
                                            "[textures.t]\ntype = \"" + Kind::kind + "\"\n" + texture.toml);
    ASSERT_EQ(file.scene.textures.size(), 1u) << Kind::kind;
    const Kind& read = std::get<Kind>(file.scene.textures[0].kind);
    EXPECT_EQ(dump(read), dump(texture.value)) << Kind::kind;
    Texture prepared{"", texture.value};
    if constexpr (std::is_same_v<Kind, ImageTexture>) std::get<Kind>(prepared.kind).image = read.image;
    prepared.prepare(file.scene.textures);
    EXPECT_EQ(file.scene.textures[0].color({0.3f, 0.7f}), prepared.color({0.3f, 0.7f}))
        << "not prepared: " << Kind::kind;
  });
}

std::string material_dump(Material material) {
  test::ParameterDump visitor;
  for_each_material_parameter(material, visitor);
  return visitor.text();
}

// With the material 'part', if the parameters name it.
std::string scene_with_material(const std::string& kind, const std::string& parameters) {
  const bool has_part = parameters.find("\"part\"") != std::string::npos;
  return "[[shapes]]\ntype = \"sphere\"\nmaterial = \"m\"\n[materials.m]\ntype = \"" + kind + "\"\n" +
         parameters + (has_part ? "[materials.part]\ntype = \"matte\"\n" : "");
}

// The parameters that a material made of others must have.
std::string required_parts(Material material) {
  std::string lines;
  for_each_material_parameter(material, [&](const ParameterInfo& info, auto& value) {
    if constexpr (std::is_same_v<std::decay_t<decltype(value)>, MaterialId>)
      lines += fmt::format("{} = \"part\"\n", info.name);
  });
  return lines;
}

TEST(TomlValues, MaterialsOfEveryKind) {
  for (const std::string& kind : kind_names<Lobes>()) {
    const SceneFolder folder;
    Material material{"m", *make_kind<Lobes>(kind), {}, {1}};
    test::ParameterFiller filler("");
    for_each_material_parameter(material, filler);
    const SceneFile file = folder.read_toml(scene_with_material(kind, filler.toml()));
    const bool has_part = !required_parts(material).empty();
    ASSERT_EQ(file.scene.materials.size(), has_part ? 2u : 1u) << kind;
    const Material& read = file.scene.materials.back();
    EXPECT_EQ(read.name, "m");
    EXPECT_EQ(material_dump(read), material_dump(material)) << kind;
    EXPECT_TRUE(read.maps.empty());
    EXPECT_EQ(!read.parts.empty(), has_part);
  }
}

TEST(TomlValues, MetalsByTheirNames) {
  const SceneFolder folder;
  const SceneFile file = folder.read_toml(scene_with_material("conductor", "metal = \"Cu\"\n"));
  EXPECT_EQ(std::get<Conductor>(file.scene.materials.at(0).lobe).metal, Metal::Cu);
}

// The texture in that parameter, if it is one that the material has beside its lobe.
std::optional<TextureId> common_map(const Material& material, const std::string& name) {
  if (name == "alpha") return material.alpha.map;
  if (name == "normal_map") return material.normal_map.map;
  if (name == "clearcoat_normal_map") return material.clearcoat_normal_map.map;
  if (name == "bump_map") return material.bump_map.map;
  return std::nullopt;
}

// A checker of one colour in the place of each parameter, by name and written in place.
TEST(TomlValues, EveryMaterialParameterTakesATexture) {
  for (const std::string& kind : kind_names<Lobes>()) {
    std::vector<ParameterInfo> infos;
    Material prototype{"m", *make_kind<Lobes>(kind), {}, {1}};
    for_each_material_parameter(prototype, [&](const ParameterInfo& info, auto& value) {
      if constexpr (requires { value.map; }) infos.push_back(info);
    });
    for (const ParameterInfo& info : infos) {
      const float value = std::max(info.range.low, 0.0f) + 0.25f;
      const std::string texture = fmt::format("type = \"checker\"\neven = {0}\nodd = {0}\n", value);
      const std::string in_place = fmt::format("{{ type = \"checker\", even = {0}, odd = {0} }}", value);
      const SceneFolder folder;
      for (const bool by_name : {true, false}) {
        const std::string use =
            fmt::format("{}{} = {}\n", required_parts(prototype), info.name, by_name ? "\"t\"" : in_place);
        const SceneFile file =
            folder.read_toml((by_name ? "[textures.t]\n" + texture : "") + scene_with_material(kind, use));
        const Material& material = file.scene.materials.back();
        if (const auto map = common_map(material, info.name)) {
          ASSERT_NE(*map, TextureId::none) << kind << " " << info.name;
          EXPECT_FLOAT_EQ(file.scene.textures[index_of(*map)].number({0.1f, 0.1f}), value);
          continue;
        }
        ASSERT_EQ(material.maps.size(), 1u) << kind << " " << info.name;
        Material evaluated{"m", material.at({0.1f, 0.1f}, file.scene.textures), {}, {1}};
        for_each_material_parameter(evaluated, [&](const ParameterInfo& other, auto& textured) {
          if (std::string(other.name) != info.name) return;
          if constexpr (std::is_same_v<std::decay_t<decltype(textured)>, Textured<float>>) {
            EXPECT_FLOAT_EQ(textured.value, value) << kind << " " << info.name;
          } else if constexpr (std::is_same_v<std::decay_t<decltype(textured)>, Textured<Spectrum>>) {
            EXPECT_EQ(textured.value, grey(value)) << kind << " " << info.name;
          }
        });
      }
    }
  }
}

TEST(TomlValues, ColoursHaveThreeForms) {
  const SceneFolder folder;
  const auto intensity = [&](const std::string& value) {
    const SceneFile file = folder.read_toml(std::string(environment) +
                                            "[[lights]]\ntype = \"point\"\nintensity = " + value + "\n");
    return std::get<PointLight>(file.scene.lights.at(0)).intensity;
  };
  EXPECT_EQ(intensity("[1, 2.5, 3]"), rgb(1, 2.5f, 3));
  EXPECT_EQ(intensity("4"), grey(4));
  EXPECT_EQ(intensity("\"#ff8000\""), rgb(1, srgb_decode(128 / 255.0f), 0));
  EXPECT_EQ(intensity("\"#00FFff\""), rgb(0, 1, 1));
}

TEST(TomlValues, EmissionIsAConstantOrATexture) {
  const SceneFolder folder;
  const SceneFile file = folder.read_toml(R"([[shapes]]
type = "disk"
emission = [1, 2, 3]
two_sided = true
[[shapes]]
type = "disk"
emission = { type = "checker", even = 5 }
)");
  ASSERT_EQ(file.scene.shapes.size(), 2u);
  EXPECT_EQ(file.scene.shapes[0].emission.value, rgb(1, 2, 3));
  EXPECT_TRUE(file.scene.shapes[0].two_sided);
  EXPECT_FALSE(file.scene.shapes[1].two_sided);
  ASSERT_FALSE(file.scene.shapes[1].emission.is_constant());
  // Emitters that name no material reflect nothing, and share one that does so.
  ASSERT_EQ(file.scene.materials.size(), 1u);
  EXPECT_EQ(std::get<Lambert>(file.scene.materials[0].lobe).reflectance, black);
}

TEST(TomlValues, SettingsOfEveryIntegratorAreRead) {
  const SceneFolder folder;
  folder.write("scene.toml", std::string(environment) +
                                 "[integrator]\ntype = \"local\"\n[integrator.path]\nmax_depth = 3\n"
                                 "[integrator.local]\nweight = 0.25\n");
  test::StandInSettings settings;
  const SceneFile file = read_scene_file(folder.path("scene.toml"), test::stand_in_integrators(settings));
  EXPECT_EQ(file.integrator, "local");
  EXPECT_EQ(settings.max_depth, 3);
  EXPECT_EQ(settings.weight.value, 0.25f);
  EXPECT_EQ(settings.reads, (std::map<std::string, int>{{"local", 1}, {"path", 1}}));
}

TEST(TomlValues, WhatIsNotSaidHasItsDefault) {
  const SceneFolder folder;
  folder.write("scene.toml", environment);
  test::StandInSettings settings;
  const SceneFile file = read_scene_file(folder.path("scene.toml"), test::stand_in_integrators(settings));
  EXPECT_EQ(file.integrator, "path");
  EXPECT_EQ(settings.max_depth, 7);
  EXPECT_EQ(settings.reads.size(), 2u);
  EXPECT_EQ(dump(file.film), dump(FilmSettings{}));
  EXPECT_EQ(dump(file.sampling), dump(SamplingSettings{}));
}

}  // namespace
}  // namespace umbral
