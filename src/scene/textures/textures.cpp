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

void Texture::prepare(std::span<const Texture> textures) {
  std::visit(
      [&](auto& texture) {
        if constexpr (requires { texture.prepare(textures); })
          texture.prepare(textures);
        else
          texture.prepare();
      },
      kind);
}

Spectrum Texture::color(const TexturePoint& point) const {
  return std::visit([&](const auto& texture) { return texture.evaluate(point); }, kind);
}

float Texture::number(const TexturePoint& point) const {
  return std::visit(
      [&](const auto& texture) {
        if constexpr (requires { texture.number(point); })
          return texture.number(point);
        else
          return channel_of(texture.evaluate(point), texture.channel);
      },
      kind);
}

TextureBounds Texture::color_bounds() const {
  return std::visit([](const auto& texture) { return texture.bounds(); }, kind);
}

Range Texture::number_bounds() const {
  return std::visit(
      [](const auto& texture) {
        if constexpr (requires { texture.number_bounds(); }) {
          return texture.number_bounds();
        } else {
          const TextureBounds bounds = texture.bounds();
          return Range{channel_of(bounds.low, texture.channel), channel_of(bounds.high, texture.channel)};
        }
      },
      kind);
}

unsigned Texture::needs() const {
  return std::visit([](const auto& texture) { return texture.needs(); }, kind);
}

TextureStep Texture::step() const {
  return std::visit([](const auto& texture) { return texture.step(); }, kind);
}

Vec2 Texture::placed(const TexturePoint& point) const {
  return std::visit(
      [&](const auto& texture) {
        if constexpr (requires { texture.placed(point); })
          return texture.placed(point);
        else
          return point.uv;
      },
      kind);
}

}  // namespace umbral
