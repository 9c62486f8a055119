// Blends of textures and their bounds.
#include "scene/textures/mix_texture.h"

namespace umbral {

void MixTexture::prepare(std::span<const Texture> textures) {
  a_input = TextureInput(a, textures);
  b_input = TextureInput(b, textures);
  amount_input = TextureInput(amount, textures);
}

// Of values between those of a and b, as the amount keeps to 0 … 1.
TextureBounds MixTexture::bounds() const {
  const TextureBounds x = a_input.color_bounds(), y = b_input.color_bounds();
  return {glm::min(x.low, y.low), glm::max(x.high, y.high)};
}

Range MixTexture::number_bounds() const {
  const Range x = a_input.number_bounds(), y = b_input.number_bounds();
  return {std::min(x.low, y.low), std::max(x.high, y.high)};
}

}  // namespace umbral
