// Evaluation of textured parameters, and of materials that are made of others.
#include "scene/material.h"

namespace umbral {

std::vector<TextureId> Material::textures() const {
  std::vector<TextureId> all;
  for (const TexturedParameter& map : maps) all.push_back(map.texture);
  for (const TextureId map : {alpha.map, normal_map.map, clearcoat_normal_map.map, bump_map.map})
    if (map != TextureId::none) all.push_back(map);
  return all;
}

unsigned Material::needs(const std::vector<Texture>& scene_textures) const {
  unsigned needs = 0;
  for (const TextureId map : textures()) needs |= scene_textures[index_of(map)].needs();
  return needs;
}

bool Material::has_clearcoat_normal() const {
  const auto* principled = std::get_if<Principled>(&lobe);
  if (!principled) return false;
  const auto is_coat = [](const TexturedParameter& map) {
    return map.set == detail::set_from_texture<&Principled::clearcoat>;
  };
  if (principled->clearcoat == 0 && std::none_of(maps.begin(), maps.end(), is_coat)) return false;
  if (!has_normal_map()) return has_clearcoat_normal_map();
  return clearcoat_normal_map != normal_map || clearcoat_normal_scale != normal_scale;
}

Lobes Material::at(const TexturePoint& point, const std::vector<Texture>& textures) const {
  Lobes result = lobe;
  for (const TexturedParameter& map : maps) map.set(result, textures[index_of(map.texture)], point);
  return result;
}

void join_parts(std::vector<Material>& materials) {
  for (Material& material : materials) {
    material.varies = !material.maps.empty() || material.has_clearcoat_normal();
    for (const MaterialPart& part : material.parts) {
      const Material& made = materials[index_of(part.material)];
      part.set(material.lobe, made.lobe);
      material.varies |= made.varies;
    }
  }
}

Lobes& varying_lobe(const Material& material, const std::vector<Material>& materials,
                    const TexturePoint& point, const std::vector<Texture>& textures, LobeStack& stack) {
  Lobes& lobe = stack.push(material.at(point, textures));
  for (const MaterialPart& part : material.parts) {
    const Material& made = materials[index_of(part.material)];
    if (made.varies) part.set(lobe, varying_lobe(made, materials, point, textures, stack));
  }
  return lobe;
}

}  // namespace umbral
