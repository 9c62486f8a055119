// Pictures to look at: tone-mapped 8-bit sRGB in PNG files.
#pragma once

#include <array>
#include <span>
#include <string>

#include "core/parameters.h"
#include "core/spectrum.h"

namespace umbral {

// How linear radiance, times 2^exposure, becomes a displayable value in [0, 1] before the sRGB encoding. In
// all of them what lies within [0, 1] keeps its value, but for `reinhard`.
//   hue       a colour whose largest channel is above 1 is divided by it: brightness is cut, the hue stays
//   clip      each channel is cut at 1 for itself
//   reinhard  divided by 1 + its largest channel: everything gets darker, nothing is cut
enum class ToneMap { hue, clip, reinhard };

template <>
struct EnumNames<ToneMap> {
  static constexpr std::array<const char*, 3> names{"hue", "clip", "reinhard"};
};

// The displayable colour for finite `linear`, each channel in [0, 1], before the sRGB encoding. Negative channels
// become 0.
Spectrum tone_mapped(const Spectrum& linear, float exposure_stops, ToneMap tone_map);

// The colour that a viewer shows for `linear`: sRGB-encoded, each channel in [0, 1]. Negative channels become
// 0; a colour that is not a number becomes magenta (1, 0, 1), an infinite one white.
Spectrum display_colour(const Spectrum& linear, float exposure_stops, ToneMap tone_map);

// Pixels row by row from the top. The file appears under its name when it is complete (see AtomicFile).
// Throws OutputError.
void write_png(const std::string& path, int width, int height, std::span<const Spectrum> linear,
               float exposure_stops = 0, ToneMap tone_map = ToneMap::hue);

}  // namespace umbral
