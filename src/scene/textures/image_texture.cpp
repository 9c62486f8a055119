// Look-up of an image texture and the bounds of what it can give.
#include "scene/textures/image_texture.h"

namespace umbral {

Spectrum ImageTexture::evaluate(const TexturePoint& point) const {
  return image->lookup(placed(point), wrap, filter) * factor + bias;
}

TextureBounds ImageTexture::bounds() const {
  auto [low, high] = image->min_max();
  if (wrap == Wrap::none) {  // beyond the image every channel is 0
    low = glm::min(low, Spectrum(0.0f));
    high = glm::max(high, Spectrum(0.0f));
  }
  const Spectrum a = low * factor + bias, b = high * factor + bias;
  return {glm::min(a, b), glm::max(a, b)};
}

// Half a texel.
TextureStep ImageTexture::step() const {
  const auto texels = static_cast<float>(std::max(image->width(), image->height()));
  return {0.5f / (texels * std::max({std::abs(uv_scale.x), std::abs(uv_scale.y), 1e-6f}))};
}

}  // namespace umbral
