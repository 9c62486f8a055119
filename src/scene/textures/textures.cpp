// A texture's value by its kind, as a colour or as one number of it.
#include "scene/textures/textures.h"

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
