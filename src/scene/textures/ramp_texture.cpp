// The colour between two stops.
#include "scene/textures/ramp_texture.h"

#include <algorithm>

namespace umbral {

Spectrum RampTexture::at(float number) const {
  const auto above = std::upper_bound(stops.begin(), stops.end(), number,
                                      [](float x, const ColorStop& stop) { return x < stop.at; });
  if (above == stops.begin()) return stops.front().color;
  const ColorStop& below = *(above - 1);
  if (above == stops.end() || interpolation == RampInterpolation::constant) return below.color;
  float share = (number - below.at) / (above->at - below.at);
  if (interpolation == RampInterpolation::smooth) share *= share * (3 - 2 * share);
  return mix(below.color, above->color, share);
}

TextureBounds RampTexture::bounds() const {
  TextureBounds bounds{stops.front().color, stops.front().color};
  for (const ColorStop& stop : stops)
    bounds = {glm::min(bounds.low, stop.color), glm::max(bounds.high, stop.color)};
  return bounds;
}

}  // namespace umbral
