// The choice of a lobe for a glTF material, and its parameters.
#include "formats/gltf/looks.h"

#include <fmt/format.h>

namespace umbral::gltf {
namespace {

Spectrum spectrum(const Rgb& c) {
  return rgb(static_cast<float>(c[0]), static_cast<float>(c[1]), static_cast<float>(c[2]));
}

}  // namespace

Looks::Looks(const Document& document, SceneBuilder& builder, const std::filesystem::path& folder,
             const MaterialOverrides& overrides, Report& report)
    : document_(document),
      builder_(builder),
      overrides_(overrides),
      report_(report),
      textures_(document, builder, folder, report) {}

const Look& Looks::of(const Primitive& primitive) {
  const bool vertex_colors = primitive.attributes.contains("COLOR_0");
  const auto key = std::pair(primitive.material.index, vertex_colors);
  const auto known = looks_.find(key);
  if (known != looks_.end()) return known->second;
  return looks_.emplace(key, converted(primitive.material, vertex_colors)).first->second;
}

Look Looks::converted(Ref<List::materials> ref, bool) {
  const MaterialData data = ref ? document_.materials[ref.index] : MaterialData{};
  if (!data.name.empty()) names_.insert(data.name);
  const std::string path = fmt::format("/materials/{}", ref.index);
  Look look;
  const Rgba& base = data.metallic_roughness.base_color;
  Material material{data.name, Lambert{}, {}, {1}};
  for_each_material_parameter(material, [&](const ParameterInfo& info, auto& value) {
    if constexpr (std::is_same_v<std::decay_t<decltype(value)>, Textured<Spectrum>>) {
      if (std::string(info.name) != "reflectance") return;
      value = {spectrum({base[0], base[1], base[2]})};
      if (const auto& slot = data.metallic_roughness.base_color_texture)
        if (const auto id = textures_.texture(*slot, {ColorSpace::srgb}, path)) value.map = *id;
    }
  });
  look.emission = {spectrum(data.emissive)};
  look.two_sided = data.double_sided;
  const auto override = overrides_.find(data.name);
  look.material = override ? *override : builder_.add(std::move(material), {{report_.file()}});
  return look;
}

}  // namespace umbral::gltf
