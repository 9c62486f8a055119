// The complex indices of metals.
#pragma once

#include <array>

#include "core/parameters.h"
#include "core/spectrum.h"

namespace umbral {

// By chemical symbol; `none` stands for one that is told by its reflectance or index instead. CuZn is brass. MgO and TiO2
// are no metals but stand in other renderers' lists of them: their surfaces reflect as they do, and let no light in.
enum class Metal { none, Ag, Al, Au, Be, Cr, Cu, CuZn, Hg, Ir, Li, MgO, Mo, Ni, Rh, Ta, TiN, TiO2, V, W };

template <>
struct EnumNames<Metal> {
  static constexpr std::array names{"none", "Ag",  "Al", "Au", "Be", "Cr", "Cu",  "CuZn", "Hg", "Ir",
                                    "Li",   "MgO", "Mo", "Ni", "Rh", "Ta", "TiN", "TiO2", "V",  "W"};
};

struct ComplexIndex {
  Spectrum eta, k;
};

// The index that reflects, at 0° and 75° and in each of r, g and b, what the measured spectra [Palik 1998] reflect there
// of light with a flat spectrum. At other angles the two differ by less than 0.005. `metal` is not none.
ComplexIndex metal_index(Metal metal);

}  // namespace umbral
