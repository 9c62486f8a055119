// Evaluation of textured parameters.
#include "scene/material.h"

namespace umbral {

Lobes Material::textured_at(const Vec2& uv, const std::vector<Texture>& textures) const {
  Lobes result = lobe;
  for (const TexturedParameter& map : maps) map.set(result, textures[index_of(map.texture)], uv);
  return result;
}

}  // namespace umbral
