// Texels in memory: their formats, and a grid of them in 4 × 4 tiles.
#pragma once

#include <array>
#include <bit>
#include <cstdint>

#if defined(__F16C__) && defined(__SSE4_1__)
#define UMBRAL_TEXELS_BY_SSE
#include <immintrin.h>
#endif

#include <glm/gtc/packing.hpp>

#include "core/huge_pages.h"
#include "core/spectrum.h"

namespace umbral {

// A format says how a texel is stored and what it means: linear RGB and alpha. Alpha is never encoded.

// The linear values of the 256 codes of sRGB.
extern const std::array<float, 256> srgb_codes;

struct Srgb8 {
  using Stored = std::array<std::uint8_t, 4>;
  static Spectrum decoded(const Stored& t) {
    return {srgb_codes[t[0]], srgb_codes[t[1]], srgb_codes[t[2]], static_cast<float>(t[3]) * (1 / 255.0f)};
  }
};

struct Linear8 {
  using Stored = std::array<std::uint8_t, 4>;
  static Spectrum decoded(const Stored& t) {
#if defined(UMBRAL_TEXELS_BY_SSE)
    const __m128i codes = _mm_cvtepu8_epi32(_mm_cvtsi32_si128(std::bit_cast<int>(t)));
    return std::bit_cast<Spectrum>(_mm_mul_ps(_mm_cvtepi32_ps(codes), _mm_set1_ps(1 / 255.0f)));
#else
    return Spectrum(t[0], t[1], t[2], t[3]) * (1 / 255.0f);
#endif
  }
};

// IEEE binary16.
struct Half4 {
  using Stored = std::uint64_t;  // r in the lowest 16 bits
  static Stored encoded(const Spectrum& value) { return glm::packHalf4x16(value); }
  static Spectrum decoded(Stored t) {
#if defined(UMBRAL_TEXELS_BY_SSE)
    return std::bit_cast<Spectrum>(_mm_cvtph_ps(_mm_cvtsi64_si128(static_cast<long long>(t))));
#else
    return glm::unpackHalf4x16(t);
#endif
  }
};

struct Float4 {
  using Stored = Spectrum;
  static Stored encoded(const Spectrum& value) { return value; }
  static Spectrum decoded(const Stored& t) { return t; }
};

// Neighbours in x and in y share a cache line: a tile is 64 bytes of 8-bit texels.
template <class Format>
class TexelGrid {
 public:
  using Stored = typename Format::Stored;

  TexelGrid() = default;
  TexelGrid(int width, int height)
      : width_(width),
        height_(height),
        tiles_across_((width + 3) / 4),
        texels_(16 * static_cast<std::size_t>(tiles_across_) * ((height + 3) / 4)) {}

  int width() const { return width_; }
  int height() const { return height_; }
  Spectrum at(int x, int y) const { return Format::decoded(texels_[offset(x, y)]); }
  void set(int x, int y, const Stored& texel) { texels_[offset(x, y)] = texel; }
  std::size_t memory() const { return texels_.size() * sizeof(Stored); }

 private:
  std::size_t offset(int x, int y) const {
    const std::size_t tile = static_cast<std::size_t>(y >> 2) * tiles_across_ + (x >> 2);
    return tile * 16 + ((y & 3) << 2) + (x & 3);
  }

  int width_ = 0, height_ = 0, tiles_across_ = 0;
  HugeVector<Stored> texels_;
};

}  // namespace umbral
