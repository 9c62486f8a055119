// What a scene file says of the image to be made: its film and its samples.
#pragma once

#include <array>
#include <tuple>

#include "core/parameters.h"
#include "core/sampler.h"
#include "image/filter.h"

namespace umbral {

template <>
struct EnumNames<SamplerKind> {
  static constexpr std::array names{"independent", "sobol"};
};

struct FilmSettings {
  int width = 512, height = 512;
  FilterKind filter = FilterKind::gaussian;
  float filter_radius = 0;

  static constexpr const char* kind = "film";
  static constexpr const char* doc = "the image: its size and reconstruction filter";
  static constexpr auto parameters =
      std::tuple{parameter<&FilmSettings::width>("width", "pixels", Range{1, 65536}),
                 parameter<&FilmSettings::height>("height", "pixels", Range{1, 65536}),
                 parameter<&FilmSettings::filter>("filter", "which samples make a pixel"),
                 parameter<&FilmSettings::filter_radius>("filter_radius", "pixels; 0 is the filter's own",
                                                         Range{0, 16})};
};

struct SamplingSettings {
  int spp = 64;
  int replicates = 8;
  SamplerKind sampler = SamplerKind::sobol;
  std::uint64_t seed = 0;

  static constexpr const char* kind = "sampling";
  static constexpr const char* doc = "how many samples, and which";
  static constexpr auto parameters = std::tuple{
      parameter<&SamplingSettings::spp>("spp", "samples per pixel, in all replicates together",
                                        Range{1, 1 << 30}),
      parameter<&SamplingSettings::replicates>(
          "replicates", "independent parts of a pixel's samples, from whose spread its error bar comes",
          Range{1, 1024}),
      parameter<&SamplingSettings::sampler>("sampler", "where samples come from"),
      parameter<&SamplingSettings::seed>("seed", "another seed gives an independent image")};
};

}  // namespace umbral
