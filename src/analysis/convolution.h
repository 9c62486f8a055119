// Separable filters over one plane of an image, whose border pixels go on beyond it.
#pragma once

#include <vector>

namespace umbral {

// The weights of a filter at −radius … radius; all that are used together have one length, which is odd.
using Kernel = std::vector<float>;

struct Plane {
  int width = 0, height = 0;
  std::vector<float> values;  // row by row

  Plane(int w, int h)
      : width(w), height(h), values(static_cast<std::size_t>(w) * static_cast<std::size_t>(h)) {}
  float* row(int y) { return values.data() + static_cast<std::size_t>(y) * static_cast<std::size_t>(width); }
  const float* row(int y) const {
    return values.data() + static_cast<std::size_t>(y) * static_cast<std::size_t>(width);
  }
};

// `in` filtered along x by `across` and along y by `down`, for each of the pairs; a term of the sum a pair.
struct SeparableTerm {
  const Kernel& across;
  const Kernel& down;
};
Plane filtered(const Plane& in, const std::vector<SeparableTerm>& terms);

}  // namespace umbral
