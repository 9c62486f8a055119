// Products of textures and their bounds.
#include "scene/textures/scale_texture.h"

namespace umbral {

void ScaleTexture::prepare(std::span<const Texture> textures) {
  texture_input = TextureInput(texture, textures);
  scale_input = TextureInput(scale, textures);
}

TextureBounds ScaleTexture::bounds() const {
  const auto [a, b] = texture_input.color_bounds();
  const auto [c, d] = scale_input.color_bounds();
  return {glm::min(glm::min(a * c, a * d), glm::min(b * c, b * d)),
          glm::max(glm::max(a * c, a * d), glm::max(b * c, b * d))};
}

Range ScaleTexture::number_bounds() const {
  const Range a = texture_input.number_bounds(), b = scale_input.number_bounds();
  const auto [low, high] = std::minmax({a.low * b.low, a.low * b.high, a.high * b.low, a.high * b.high});
  return {low, high};
}

}  // namespace umbral
