// Spectrum: linear RGB (Rec. 709 primaries) with an idle fourth lane, so that it fills one SSE register.
#pragma once

#include "core/math.h"

namespace umbral {

// Radiance in W m⁻² sr⁻¹ per channel, or a reflectance in [0, 1]; which of the two, the name that holds it says.
using Spectrum = glm::vec4;

inline Spectrum rgb(float r, float g, float b) { return {r, g, b, 0}; }
inline Spectrum grey(float value) { return {value, value, value, 0}; }

inline const Spectrum black{0, 0, 0, 0};
inline const Spectrum white{1, 1, 1, 0};

// Rec. 709 luminance.
inline float luminance(const Spectrum& s) { return 0.2126f * s.r + 0.7152f * s.g + 0.0722f * s.b; }

inline float max_component(const Spectrum& s) { return std::max({s.r, s.g, s.b}); }
inline float min_component(const Spectrum& s) { return std::min({s.r, s.g, s.b}); }

inline bool is_black(const Spectrum& s) { return s.r == 0 && s.g == 0 && s.b == 0; }

inline bool is_finite(const Spectrum& s) {
  return std::isfinite(s.r) && std::isfinite(s.g) && std::isfinite(s.b);
}

// One channel of the sRGB transfer function [IEC 61966-2-1]; linear in [0, 1] to encoded in [0, 1].
inline float srgb_encode(float linear) {
  return linear <= 0.0031308f ? 12.92f * linear : 1.055f * std::pow(linear, 1 / 2.4f) - 0.055f;
}

// The inverse of srgb_encode().
inline float srgb_decode(float encoded) {
  return encoded <= 0.04045f ? encoded / 12.92f : std::pow((encoded + 0.055f) / 1.055f, 2.4f);
}

}  // namespace umbral
