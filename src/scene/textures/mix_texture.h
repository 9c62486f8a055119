// Between two textures, by a third.
#pragma once

#include <tuple>

#include "scene/textures/texture_input.h"

namespace umbral {

struct MixTexture {
  Textured<Spectrum> a{grey(0)};
  Textured<Spectrum> b{grey(1)};
  Textured<float> amount{0.5f};

  static constexpr const char* kind = "mix";
  static constexpr const char* doc = "a blend of two textures: a + amount (b − a)";
  static constexpr auto parameters =
      std::tuple{parameter<&MixTexture::a>("a", "what an amount of 0 gives"),
                 parameter<&MixTexture::b>("b", "what an amount of 1 gives"),
                 parameter<&MixTexture::amount>("amount", "from a to b", zero_to_one)};

  TextureInput a_input{}, b_input{}, amount_input{};

  void prepare(std::span<const Texture> textures);
  Spectrum evaluate(const TexturePoint& point) const {
    return mix(a_input.color(point), b_input.color(point), amount_input.number(point));
  }
  float number(const TexturePoint& point) const {
    return glm::mix(a_input.number(point), b_input.number(point), amount_input.number(point));
  }
  TextureBounds bounds() const;
  Range number_bounds() const;
  unsigned needs() const { return a_input.needs() | b_input.needs() | amount_input.needs(); }
  TextureStep step() const { return a_input.step().finer(b_input.step()).finer(amount_input.step()); }
  Vec2 placed(const TexturePoint& point) const {
    return (a_input.is_constant() ? b_input : a_input).placed(point);
  }
};

}  // namespace umbral
