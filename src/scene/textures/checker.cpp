// Which square of a checker is where.
#include "scene/textures/checker.h"

namespace umbral {

Spectrum CheckerTexture::evaluate(const Vec2& uv) const {
  const Vec2 square = glm::floor(uv_map(uv));
  const float parity = square.x + square.y - 2 * std::floor((square.x + square.y) / 2);
  return parity == 0 ? even : odd;
}

TextureBounds CheckerTexture::bounds() const { return {glm::min(even, odd), glm::max(even, odd)}; }

}  // namespace umbral
