// Colours at places of a line.
#pragma once

#include <vector>

#include "core/spectrum.h"

namespace umbral {

struct ColorStop {
  float at;
  Spectrum color;

  bool operator==(const ColorStop&) const = default;
};

// At least one; `at` rises strictly.
using ColorStops = std::vector<ColorStop>;

}  // namespace umbral
