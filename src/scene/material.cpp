// Evaluation of textured parameters.
#include "scene/material.h"

namespace umbral {

unsigned Material::needs(const std::vector<Texture>& textures) const {
  unsigned needs = 0;
  const auto add = [&](TextureId map) {
    if (map != TextureId::none) needs |= textures[index_of(map)].needs();
  };
  for (const TexturedParameter& map : maps) add(map.texture);
  for (const TextureId map : {alpha.map, normal_map.map, bump_map.map}) add(map);
  return needs;
}

Lobes Material::textured_at(const TexturePoint& point, const std::vector<Texture>& textures) const {
  Lobes result = lobe;
  for (const TexturedParameter& map : maps) map.set(result, textures[index_of(map.texture)], point);
  return result;
}

}  // namespace umbral
