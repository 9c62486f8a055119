// A scene description as TOML, part by part.
#include "app/convert/scene_writer.h"

#include <set>

#include <fmt/format.h>

#include "app/convert/image_files.h"
#include "app/convert/parameter_lines.h"
#include "formats/ply/ply_writer.h"
#include "image/atomic_file.h"

namespace umbral {
namespace {

// One TOML key a part: its own name, with a number where that is empty or taken.
template <class Part>
std::vector<std::string> unique_names(const std::vector<Part>& parts, const std::string& otherwise) {
  std::vector<std::string> names;
  std::set<std::string> taken;
  for (const Part& part : parts) {
    const std::string base = part.name.empty() ? otherwise : part.name;
    std::string name = part.name.empty() ? base + "-0" : base;
    for (int number = 1; !taken.insert(name).second; ++number) name = fmt::format("{}-{}", base, number);
    names.push_back(name);
  }
  return names;
}

std::string matrix_text(const Affine& map) {
  std::string rows;
  for (int r = 0; r < 3; ++r)
    rows += fmt::format("[{}, {}, {}, {}], ", map.linear[0][r], map.linear[1][r], map.linear[2][r],
                        map.offset[r]);
  return "[{ matrix = [" + rows + "[0, 0, 0, 1]] }]";
}

class SceneWriter {
 public:
  SceneWriter(const SceneDescription& scene, const std::filesystem::path& source,
              const std::filesystem::path& path)
      : scene_(scene),
        folder_(path.parent_path()),
        assets_(path.stem().string() + "-files"),
        images_(path.parent_path(), assets_, source.parent_path()),
        textures_(unique_names(scene.textures, "texture")),
        materials_(unique_names(scene.materials, "material")),
        objects_(unique_names(scene.objects, "object")) {}

  std::string text(const LoadedScene& loaded);

 private:
  template <class T>
  void add_table(const std::string& header, const T& described) {
    const std::string lines = changed_lines(described, textures_);
    if (!lines.empty()) text_ += fmt::format("[{}]\n{}\n", header, lines);
  }
  void add_integrators(const LoadedScene& loaded);
  void find_used();
  void use(TextureId texture);
  void use(MaterialId material);
  void add_texture(std::size_t number);
  void add_material(std::size_t number);
  void add_shape(const Shape& shape, const std::string& header);
  void add_shapes();
  template <class Light>
  void add_light(Light light);

  const SceneDescription& scene_;
  std::filesystem::path folder_, assets_;
  ImageFiles images_;
  std::vector<std::string> textures_, materials_, objects_;
  std::set<std::uint32_t> used_textures_, used_materials_;
  std::size_t meshes_ = 0;
  std::string text_;
};

void SceneWriter::use(TextureId id) {
  if (id == TextureId::none || !used_textures_.insert(index_of(id)).second) return;
  std::visit(
      [&](auto texture) {
        for_each_parameter(texture, [&](const ParameterInfo&, auto& value) {
          if constexpr (requires { value.map; }) use(value.map);
        });
      },
      scene_.textures[index_of(id)].kind);
}

void SceneWriter::use(MaterialId id) {
  if (!used_materials_.insert(index_of(id)).second) return;
  const Material& material = scene_.materials[index_of(id)];
  for (const MaterialPart& part : material.parts) use(part.material);
  for (const TextureId map : material.textures()) use(map);
}

void SceneWriter::find_used() {
  const auto use_shapes = [&](const std::vector<Shape>& shapes) {
    for (const Shape& shape : shapes) {
      use(shape.emission.map);
      use(shape.material);
    }
  };
  use_shapes(scene_.shapes);
  for (const Instance& instance : scene_.instances)
    use_shapes(scene_.objects[index_of(instance.object)].shapes);
}

void SceneWriter::add_texture(std::size_t number) {
  std::visit(
      [&](auto texture) {
        if constexpr (std::is_same_v<decltype(texture), ImageTexture>) {
          const auto place = texture.tiles
                                 ? images_.place_of(*texture.tiles, texture.file, texture.color_space)
                                 : images_.place_of(texture.image, texture.file, texture.color_space);
          texture.file = place.file;
          texture.color_space = place.color_space;
        }
        text_ += fmt::format("[textures.{}]\ntype = \"{}\"\n{}\n", toml_string(textures_[number]),
                             texture.kind, changed_lines(texture, textures_));
      },
      scene_.textures[number].kind);
}

void SceneWriter::add_material(std::size_t number) {
  Material material = scene_.materials[number];
  TexturedTexts given(textures_), defaults(textures_);
  const auto visit_one = [&](auto& lobe, const auto& parameter) {
    constexpr auto member = std::remove_reference_t<decltype(parameter)>::member;
    auto& value = lobe.*member;
    using T = std::remove_reference_t<decltype(value)>;
    if constexpr (std::is_same_v<T, float> || std::is_same_v<T, Spectrum>) {
      Textured<T> textured{value};
      for (const TexturedParameter& map : material.maps)
        if (map.set == detail::set_from_texture<member>) textured.map = map.texture;
      given(parameter.info, textured);
    } else if constexpr (std::is_same_v<T, const Lobes*>) {
      for (const MaterialPart& part : material.parts)
        if (part.set == detail::set_part<member>) given(parameter.info, materials_[index_of(part.material)]);
    } else {
      given(parameter.info, value);
    }
  };
  std::visit(
      [&](auto& lobe) {
        using Lobe = std::remove_reference_t<decltype(lobe)>;
        std::apply([&](const auto&... p) { (visit_one(lobe, p), ...); }, Lobe::parameters);
        Material fresh{"", Lobe{}, {}};
        for_each_material_parameter(fresh, defaults);
      },
      material.lobe);
  for_each_common_parameter(material, given);
  text_ += fmt::format("[materials.{}]\ntype = \"{}\"\n{}\n", toml_string(materials_[number]),
                       kind_of(material.lobe), changed_lines(given.texts(), defaults.texts()));
}

void SceneWriter::add_shape(const Shape& shape, const std::string& header) {
  const auto* mesh = std::get_if<Mesh>(&shape.kind);
  text_ += fmt::format("[[{}]]\n", header);
  if (!shape.name.empty()) text_ += fmt::format("name = {}\n", toml_string(shape.name));
  if (mesh) {
    std::filesystem::create_directories(folder_ / assets_);
    const std::filesystem::path file = assets_ / fmt::format("mesh-{}.ply", meshes_++);
    write_ply((folder_ / file).string(), *mesh);
    text_ += fmt::format("type = \"mesh\"\nfile = {}\n", toml_string(file.generic_string()));
  } else {
    std::visit(
        [&](const auto& kind) {
          text_ += fmt::format("type = \"{}\"\n{}", kind.kind, changed_lines(kind, textures_));
        },
        shape.kind);
  }
  text_ += fmt::format("material = {}\n", toml_string(materials_[index_of(shape.material)]));
  if (shape.emits()) {
    TexturedTexts emission(textures_);
    Textured<Spectrum> value = shape.emission;
    emission(ParameterInfo{"emission", ""}, value);
    text_ += fmt::format("emission = {}\n{}", emission.texts()[0].value,
                         shape.two_sided ? "two_sided = true\n" : "");
  }
  if (!shape.to_world.is_identity()) text_ += fmt::format("transform = {}\n", matrix_text(shape.to_world));
  text_ += '\n';
}

void SceneWriter::add_shapes() {
  for (const Shape& shape : scene_.shapes) add_shape(shape, "shapes");
  std::set<std::uint32_t> placed;
  for (const Instance& instance : scene_.instances) placed.insert(index_of(instance.object));
  for (const std::uint32_t object : placed)
    for (const Shape& shape : scene_.objects[object].shapes)
      add_shape(shape, fmt::format("objects.{}.shapes", toml_string(objects_[object])));
  for (const Instance& instance : scene_.instances) {
    text_ += fmt::format("[[instances]]\nobject = {}\n", toml_string(objects_[index_of(instance.object)]));
    if (!instance.to_world.is_identity())
      text_ += fmt::format("transform = {}\n", matrix_text(instance.to_world));
    text_ += '\n';
  }
}

template <class Light>
void SceneWriter::add_light(Light light) {
  if constexpr (requires { light.image; })
    if (light.image) light.file = images_.place_of(light.image, light.file, ColorSpace::automatic).file;
  std::string turn;
  if constexpr (requires { light.image_from_world; }) {
    if (const std::optional<Mat3> map = light.image_from_world) {
      if constexpr (requires { light.rotation; }) light.rotation = 0;
      turn = fmt::format("transform = {}\n", matrix_text({glm::dmat3(glm::transpose(*map)), Vec3d(0)}));
    }
  }
  text_ +=
      fmt::format("[[lights]]\ntype = \"{}\"\n{}{}\n", light.kind, changed_lines(light, textures_), turn);
}

void SceneWriter::add_integrators(const LoadedScene& loaded) {
  text_ += fmt::format("[integrator]\ntype = \"{}\"\n\n", loaded.file.integrator);
  for (const auto& [kind, integrator] : loaded.integrators) {
    TexturedTexts given(textures_), defaults(textures_);
    integrator->describe(given);
    make_integrator(kind)->describe(defaults);
    const std::string lines = changed_lines(given.texts(), defaults.texts());
    if (!lines.empty()) text_ += fmt::format("[integrator.{}]\n{}\n", kind, lines);
  }
}

std::string SceneWriter::text(const LoadedScene& loaded) {
  text_ += "[camera]\n" + changed_lines(scene_.camera, textures_) + '\n';
  add_table("film", loaded.file.film);
  add_table("sampling", loaded.file.sampling);
  add_integrators(loaded);
  find_used();
  for (const std::uint32_t texture : used_textures_) add_texture(texture);
  for (const std::uint32_t material : used_materials_) add_material(material);
  for (const LightKinds& light : scene_.lights) std::visit([&](const auto& kind) { add_light(kind); }, light);
  if (scene_.environment) add_light(*scene_.environment);
  add_shapes();
  return text_;
}

}  // namespace

void write_scene(const LoadedScene& scene, const std::filesystem::path& source,
                 const std::filesystem::path& path) {
  write_file(path.string(), SceneWriter(scene.file.scene, source, path).text(scene));
}

}  // namespace umbral
