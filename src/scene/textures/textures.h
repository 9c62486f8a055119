// The closed list of textures: functions from uv to a value that a material's parameter or an emission takes.
#pragma once

#include <string>
#include <variant>

#include "scene/ids.h"
#include "scene/textures/checker.h"
#include "scene/textures/image_texture.h"

namespace umbral {

// A new texture joins here.
using TextureKinds = std::variant<ImageTexture, CheckerTexture>;

struct Texture {
  std::string name;
  TextureKinds kind;

  void prepare();
  Spectrum color(const Vec2& uv) const;
  float number(const Vec2& uv) const;  // the chosen channel
  TextureBounds color_bounds() const;
  Range number_bounds() const;
};

}  // namespace umbral
