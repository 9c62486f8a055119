// One texture times another, or times a constant.
#pragma once

#include <tuple>

#include "scene/textures/texture_input.h"

namespace umbral {

struct ScaleTexture {
  Textured<Spectrum> texture{grey(1)};
  Textured<Spectrum> scale{grey(1)};

  static constexpr const char* kind = "scale";
  static constexpr const char* doc = "one texture times another, or times a constant";
  static constexpr auto parameters =
      std::tuple{parameter<&ScaleTexture::texture>("texture", "what is multiplied"),
                 parameter<&ScaleTexture::scale>("scale",
                                                 "by what, channel by channel; for a parameter that takes "
                                                 "one number, the numbers of both are multiplied")};

  TextureInput texture_input{}, scale_input{};

  void prepare(std::span<const Texture> textures);
  Spectrum evaluate(const TexturePoint& point) const {
    return texture_input.color(point) * scale_input.color(point);
  }
  float number(const TexturePoint& point) const {
    return texture_input.number(point) * scale_input.number(point);
  }
  TextureBounds bounds() const;
  Range number_bounds() const;
  unsigned needs() const { return texture_input.needs() | scale_input.needs(); }
  TextureStep step() const { return texture_input.step().finer(scale_input.step()); }
  Vec2 placed(const TexturePoint& point) const {
    return (texture_input.is_constant() ? scale_input : texture_input).placed(point);
  }
};

}  // namespace umbral
