// Parameters that several lobes share, as parts of the tables of each.
#pragma once

#include <tuple>

#include "core/parameters.h"

namespace umbral::detail {

// Of highlights that are longer one way.
template <class Lobe>
constexpr auto anisotropy_parameters(const char* anisotropy) {
  return std::tuple{
      parameter<&Lobe::anisotropy>("anisotropy", anisotropy, zero_to_one),
      parameter<&Lobe::anisotropy_rotation>(
          "anisotropy_rotation", "of the direction along u, degrees, counter-clockwise", Range{0, 360})};
}

inline constexpr const char* facet_anisotropy =
    "alpha is roughness² (1 ± anisotropy) along u and across it: brushed metal, ribbed glass";

// Of clear things.
template <class Lobe>
constexpr auto clear_parameters(const char* eta) {
  return std::tuple{
      parameter<&Lobe::eta>("eta", eta, Range{1, 10}),
      parameter<&Lobe::reflectance>("reflectance", "tint of what is reflected", zero_to_one),
      parameter<&Lobe::transmittance>("transmittance", "tint of what passes the surface", zero_to_one)};
}

// Of what light passes inside.
template <class Lobe>
constexpr auto attenuation_parameters() {
  return std::tuple{
      parameter<&Lobe::attenuation_color>(
          "attenuation_color", "what is left of white light inside after attenuation_distance", zero_to_one),
      parameter<&Lobe::attenuation_distance>("attenuation_distance",
                                             "world units; inf is a body that absorbs nothing",
                                             Range{0, infinity, true, false})};
}

template <class Lobe>
constexpr auto film_parameters(const char* film) {
  return std::tuple{
      parameter<&Lobe::film_eta>("film_eta", film, Range{1, 10}),
      parameter<&Lobe::film_thickness>("film_thickness", "of that film, nm; 0 is none", Range{0, 1e4f})};
}

}  // namespace umbral::detail
