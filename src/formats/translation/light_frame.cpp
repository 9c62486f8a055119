// The turn in a map that turns, mirrors and scales.
#include "formats/translation/light_frame.h"

namespace umbral {

std::optional<Mat3> light_from_world(const Affine& light_to_world) {
  const double scale = std::cbrt(std::abs(light_to_world.determinant()));
  if (!(scale > 0) || !std::isfinite(scale)) return std::nullopt;
  const glm::dmat3 turn = light_to_world.linear * (1 / scale);
  const glm::dmat3 gram = glm::transpose(turn) * turn;
  constexpr double rounding = 1e-4;  // of matrices written with five digits
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j)
      if (std::abs(gram[i][j] - (i == j ? 1 : 0)) > rounding) return std::nullopt;
  return Mat3(glm::transpose(turn));
}

}  // namespace umbral
