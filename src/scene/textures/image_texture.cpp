// Look-up of an image texture and the bounds of what it can give.
#include "scene/textures/image_texture.h"

namespace umbral {

Spectrum ImageTexture::evaluate(const TexturePoint& point) const {
  Vec2 uv = placed(point);
  const TextureImage* source = image.get();
  Wraps beyond = wraps();
  if (tiles) {
    const Vec2 square = glm::floor(uv);
    source = tiles->at(square);
    if (source == nullptr) return Spectrum(0.0f) * factor + bias;
    uv -= square;
    beyond = Wrap::clamp;
  }
  if (filter == TextureFilter::bilinear) return source->bilinear(uv, beyond) * factor + bias;
  const float side = std::sqrt(static_cast<float>(source->width()) * static_cast<float>(source->height()));
  const TextureFootprint footprint{point.footprint_of(uv_set) * footprint_scale * side, point.random};
  return source->lookup(uv, beyond, filter, footprint) * factor + bias;
}

unsigned ImageTexture::needs() const {
  unsigned needs = uv_set == 0 ? 0 : texture_needs::uv1;
  if (filter == TextureFilter::stochastic || filter == TextureFilter::mip) needs |= texture_needs::random;
  if (filter == TextureFilter::mip) needs |= texture_needs::footprint;
  return needs;
}

TextureBounds ImageTexture::bounds() const {
  auto [low, high] = image->min_max();
  if (tiles)
    for (const auto& tile : tiles->images) {
      if (!tile) continue;
      low = glm::min(low, tile->min_max().first);
      high = glm::max(high, tile->min_max().second);
    }
  if (wraps().u == Wrap::none || wraps().v == Wrap::none ||
      tiles) {  // beyond the image, and where there is no tile, every channel is 0
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
