// Products of factors, textures and vertex colours.
#include "formats/gltf/material_maps.h"

namespace umbral::gltf {
namespace {

Spectrum spectrum(const Rgb& c) {
  return rgb(static_cast<float>(c[0]), static_cast<float>(c[1]), static_cast<float>(c[2]));
}

}  // namespace

TextureId MaterialMaps::product(TextureId texture, const Textured<Spectrum>& scale) {
  Texture result{"", ScaleTexture{{white, texture}, scale}};
  result.prepare(builder_.textures);
  return builder_.add(std::move(result));
}

TextureId MaterialMaps::vertex_color(TextureChannel channel) {
  Texture result{"", VertexColorTexture{channel}};
  result.prepare(builder_.textures);
  return builder_.add(std::move(result));
}

Textured<Spectrum> MaterialMaps::color(const Rgb& factor, const TextureSlot& slot) {
  Textured<Spectrum> result{spectrum(factor)};
  if (!slot || is_black(result.value)) return result;
  const bool is_grey = factor[0] == factor[1] && factor[1] == factor[2];
  const auto id = image(*slot, {ColorSpace::srgb, TextureChannel::luminance, is_grey ? result.value.r : 1});
  if (id) result.map = is_grey ? *id : product(*id, {result.value});
  return result;
}

Textured<Spectrum> MaterialMaps::painted(const Rgb& factor, const TextureSlot& slot) {
  const Textured<Spectrum> plain = color(factor, slot);
  if (!vertex_colors_) return plain;
  const TextureId vertices = vertex_color(TextureChannel::luminance);
  if (plain.is_constant() && plain.value == white) return {white, vertices};
  return {plain.value, product(vertices, plain)};
}

Textured<float> MaterialMaps::painted_alpha(double factor, const TextureSlot& slot) {
  Textured<float> result = number(factor, std::nullopt, TextureChannel::a);
  if (slot)
    if (const auto id = image(*slot, {ColorSpace::srgb, TextureChannel::a, result.value})) result.map = *id;
  if (!vertex_colors_) return result;
  const TextureId vertices = vertex_color(TextureChannel::a);
  result.map = product(vertices, result.is_constant() ? Textured<Spectrum>{grey(result.value)}
                                                      : Textured<Spectrum>{white, result.map});
  return result;
}

Textured<float> MaterialMaps::number(double factor, const TextureSlot& slot, TextureChannel channel,
                                     double bias) {
  Textured<float> result{static_cast<float>(factor + bias)};
  if (!slot || factor == 0) return result;
  const auto id =
      image(*slot, {ColorSpace::linear, channel, static_cast<float>(factor), static_cast<float>(bias)});
  if (id) result.map = *id;
  return result;
}

std::optional<TextureId> MaterialMaps::directions(const TextureInfo& info, float rotation) {
  const auto held = image(info, {ColorSpace::linear});
  if (!held) return std::nullopt;
  Texture result{"", DirectionTexture{{white, *held}, rotation}};
  result.prepare(builder_.textures);
  return builder_.add(std::move(result));
}

}  // namespace umbral::gltf
