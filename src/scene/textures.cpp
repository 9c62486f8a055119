// Evaluation of textures and the bounds of what they can give.
#include "scene/textures.h"

namespace umbral {
namespace {

float channel_of(const Spectrum& value, TextureChannel channel) {
  switch (channel) {
    case TextureChannel::luminance:
      return luminance(value);
    case TextureChannel::r:
      return value.r;
    case TextureChannel::g:
      return value.g;
    case TextureChannel::b:
      return value.b;
    case TextureChannel::a:
      return value.a;
  }
  return 0;
}

}  // namespace

UvMap::UvMap(const UvTransform& transform) : offset_(transform.offset) {
  const float c = std::cos(glm::radians(transform.rotation)), s = std::sin(glm::radians(transform.rotation));
  row_u_ = {c * transform.scale.x, -s * transform.scale.y};
  row_v_ = {s * transform.scale.x, c * transform.scale.y};
}

Spectrum ImageTexture::evaluate(const Vec2& uv) const {
  return image->lookup(uv_map(uv), wrap, filter) * factor + bias;
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

Spectrum CheckerTexture::evaluate(const Vec2& uv) const {
  const Vec2 square = glm::floor(uv_map(uv));
  const float parity = square.x + square.y - 2 * std::floor((square.x + square.y) / 2);
  return parity == 0 ? even : odd;
}

TextureBounds CheckerTexture::bounds() const { return {glm::min(even, odd), glm::max(even, odd)}; }

void Texture::prepare() {
  std::visit([](auto& texture) { texture.prepare(); }, kind);
}

Spectrum Texture::color(const Vec2& uv) const {
  return std::visit([&](const auto& texture) { return texture.evaluate(uv); }, kind);
}

float Texture::number(const Vec2& uv) const {
  return std::visit([&](const auto& texture) { return channel_of(texture.evaluate(uv), texture.channel); },
                    kind);
}

TextureBounds Texture::color_bounds() const {
  return std::visit([](const auto& texture) { return texture.bounds(); }, kind);
}

Range Texture::number_bounds() const {
  return std::visit(
      [](const auto& texture) {
        const TextureBounds bounds = texture.bounds();
        return Range{channel_of(bounds.low, texture.channel), channel_of(bounds.high, texture.channel)};
      },
      kind);
}

}  // namespace umbral
