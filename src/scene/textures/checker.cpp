// Which square of a checker is where.
#include "scene/textures/checker.h"

namespace umbral {

Spectrum CheckerTexture::evaluate(const TexturePoint& point) const {
  const Vec2 square = glm::floor(placed(point));
  const float parity = square.x + square.y - 2 * std::floor((square.x + square.y) / 2);
  return parity == 0 ? even : odd;
}

TextureBounds CheckerTexture::bounds() const { return {glm::min(even, odd), glm::max(even, odd)}; }

}  // namespace umbral
