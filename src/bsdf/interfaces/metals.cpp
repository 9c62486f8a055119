// Indices fitted to measured spectra.
#include "bsdf/interfaces/metals.h"

#include <iterator>

namespace umbral {

ComplexIndex metal_index(Metal metal) {
  // The red of gold lies at the edge of the gamut, where reflectance is nearly 1; its k is that of the spectrum.
  static constexpr float table[][2][3] = {
      {{0.128f, 0.125f, 0.153f}, {3.986f, 3.379f, 2.391f}},  // Ag
      {{1.387f, 0.938f, 0.585f}, {7.659f, 6.633f, 5.339f}},  // Al
      {{0.020f, 0.398f, 1.603f}, {3.500f, 2.362f, 1.702f}},  // Au
      {{3.472f, 3.361f, 3.063f}, {3.183f, 3.174f, 3.155f}},  // Be
      {{3.614f, 3.108f, 1.838f}, {4.311f, 4.457f, 4.110f}},  // Cr
      {{0.214f, 0.969f, 1.222f}, {3.364f, 2.624f, 2.354f}},  // Cu
      {{0.469f, 0.520f, 1.148f}, {3.993f, 2.681f, 1.794f}},  // CuZn
      {{2.004f, 1.531f, 1.015f}, {5.257f, 4.623f, 3.775f}},  // Hg
      {{2.569f, 2.205f, 1.791f}, {4.636f, 4.302f, 3.603f}},  // Ir
      {{0.221f, 0.208f, 0.244f}, {2.946f, 2.466f, 1.856f}},  // Li
      {{1.734f, 1.741f, 1.754f}, {0, 0, 0}},                 // MgO
      {{3.718f, 3.724f, 3.058f}, {3.408f, 3.611f, 3.457f}},  // Mo
      {{1.974f, 1.759f, 1.621f}, {3.745f, 3.227f, 2.592f}},  // Ni
      {{2.165f, 1.966f, 1.717f}, {5.663f, 4.966f, 4.390f}},  // Rh
      {{1.760f, 2.516f, 2.910f}, {1.976f, 1.832f, 2.135f}},  // Ta
      {{1.401f, 1.207f, 1.500f}, {2.870f, 2.036f, 1.226f}},  // TiN
      {{2.869f, 2.955f, 3.195f}, {0, 0, 0}},                 // TiO2
      {{3.549f, 3.712f, 3.034f}, {2.908f, 3.034f, 3.420f}},  // V
      {{3.625f, 3.484f, 3.300f}, {2.904f, 2.749f, 2.501f}},  // W
  };
  static_assert(std::size(table) == EnumNames<Metal>::names.size() - 1);
  const auto& entry = table[static_cast<int>(metal) - 1];
  return {rgb(entry[0][0], entry[0][1], entry[0][2]), rgb(entry[1][0], entry[1][1], entry[1][2])};
}

}  // namespace umbral
