// Colours along a line, chosen by a number.
#pragma once

#include <array>
#include <tuple>

#include "scene/color_stops.h"
#include "scene/textures/texture_input.h"

namespace umbral {

enum class RampInterpolation { linear, smooth, constant };

template <>
struct EnumNames<RampInterpolation> {
  static constexpr std::array names{"linear", "smooth", "constant"};
};

struct RampTexture {
  Textured<float> input{0};
  ColorStops stops{{0, grey(0)}, {1, grey(1)}};
  RampInterpolation interpolation = RampInterpolation::linear;
  TextureChannel channel = TextureChannel::luminance;

  static constexpr const char* kind = "ramp";
  static constexpr const char* doc = "colours along a line, chosen by a number";
  static constexpr auto parameters = std::tuple{
      parameter<&RampTexture::input>("input", "the number that chooses"),
      parameter<&RampTexture::stops>("stops",
                                     "[[number, colour], …], the numbers rising; beyond the ends the "
                                     "colours of the ends"),
      parameter<&RampTexture::interpolation>(
          "interpolation", "between stops: straight, with level ends, or that of the stop below"),
      parameter<&RampTexture::channel>("channel", "what a parameter that takes one number gets")};

  TextureInput input_input{};

  void prepare(std::span<const Texture> textures) { input_input = TextureInput(input, textures); }
  Spectrum evaluate(const TexturePoint& point) const { return at(input_input.number(point)); }
  TextureBounds bounds() const;
  unsigned needs() const { return input_input.needs(); }
  TextureStep step() const { return input_input.step(); }
  Vec2 placed(const TexturePoint& point) const { return input_input.placed(point); }

 private:
  Spectrum at(float number) const;
};

}  // namespace umbral
