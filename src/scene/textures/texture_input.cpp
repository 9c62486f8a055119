// Inputs of textures that are made from others.
#include "scene/textures/texture_input.h"

#include "scene/textures/textures.h"

namespace umbral {
namespace {

std::shared_ptr<const Texture> chosen(TextureId map, std::span<const Texture> textures) {
  return map == TextureId::none ? nullptr : std::make_shared<const Texture>(textures[index_of(map)]);
}

}  // namespace

TextureInput::TextureInput(const Textured<Spectrum>& described, std::span<const Texture> textures)
    : constant_(Vec3(described.value), 1),
      constant_number_(luminance(described.value)),
      texture_(chosen(described.map, textures)) {}

TextureInput::TextureInput(const Textured<float>& described, std::span<const Texture> textures)
    : constant_(Vec3(described.value), 1),
      constant_number_(described.value),
      texture_(chosen(described.map, textures)) {}

Spectrum TextureInput::color(const TexturePoint& point) const {
  return texture_ ? texture_->color(point) : constant_;
}

float TextureInput::number(const TexturePoint& point) const {
  return texture_ ? texture_->number(point) : constant_number_;
}

TextureBounds TextureInput::color_bounds() const {
  return texture_ ? texture_->color_bounds() : TextureBounds{constant_, constant_};
}

Range TextureInput::number_bounds() const {
  return texture_ ? texture_->number_bounds() : Range{constant_number_, constant_number_};
}

unsigned TextureInput::needs() const { return texture_ ? texture_->needs() : 0; }

TextureStep TextureInput::step() const { return texture_ ? texture_->step() : TextureStep{}; }

Vec2 TextureInput::placed(const TexturePoint& point) const {
  return texture_ ? texture_->placed(point) : point.uv;
}

}  // namespace umbral
