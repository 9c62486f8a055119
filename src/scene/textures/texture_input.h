// TextureInput: what a texture that is made from others takes from one of them.
#pragma once

#include <memory>
#include <span>

#include "core/parameters.h"
#include "scene/ids.h"
#include "scene/textures/texture_point.h"
#include "scene/textures/texture_value.h"

namespace umbral {

struct Texture;

// A constant, or another texture, made ready. As it can hold only a texture that was ready before, no ring can be made.
class TextureInput {
 public:
  TextureInput() = default;
  // `textures` holds the one that is meant.
  TextureInput(const Textured<Spectrum>& described, std::span<const Texture> textures);
  TextureInput(const Textured<float>& described, std::span<const Texture> textures);

  bool is_constant() const { return texture_ == nullptr; }
  Spectrum color(const TexturePoint& point) const;  // with alpha; that of a constant is 1
  float number(const TexturePoint& point) const;    // of a constant colour, its luminance
  TextureBounds color_bounds() const;
  Range number_bounds() const;
  unsigned needs() const;
  TextureStep step() const;
  Vec2 placed(const TexturePoint& point) const;

 private:
  Spectrum constant_{0, 0, 0, 1};
  float constant_number_ = 0;
  std::shared_ptr<const Texture> texture_;
};

}  // namespace umbral
