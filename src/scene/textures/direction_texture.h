// The angle of a direction that a texture holds, as for brushed metals.
#pragma once

#include <tuple>

#include "scene/textures/texture_input.h"

namespace umbral {

struct DirectionTexture {
  Textured<Spectrum> texture{rgb(1, 0.5f, 0.5f)};
  float rotation = 0;

  static constexpr const char* kind = "direction";
  static constexpr const char* doc =
      "an angle in degrees, 0 … 360: that of the direction (2 red − 1, 2 green − 1) of another texture, "
      "along u and v";
  static constexpr auto parameters = std::tuple{
      parameter<&DirectionTexture::texture>("texture", "what holds the directions, read as linear"),
      parameter<&DirectionTexture::rotation>("rotation", "added, degrees, counter-clockwise")};

  TextureInput texture_input{};

  void prepare(std::span<const Texture> textures) { texture_input = TextureInput(texture, textures); }
  Spectrum evaluate(const TexturePoint& point) const { return grey(number(point)); }
  float number(const TexturePoint& point) const {
    const Spectrum held = texture_input.color(point);
    const float turns = (std::atan2(2 * held.g - 1, 2 * held.r - 1) + glm::radians(rotation)) / two_pi;
    return 360 * std::min(turns - std::floor(turns), one_minus_epsilon);
  }
  static TextureBounds bounds() { return {grey(0), grey(360)}; }
  static Range number_bounds() { return {0, 360}; }
  unsigned needs() const { return texture_input.needs(); }
  TextureStep step() const { return texture_input.step(); }
  Vec2 placed(const TexturePoint& point) const { return texture_input.placed(point); }
};

}  // namespace umbral
