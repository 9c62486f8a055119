// Integer hashing: independent streams from (seed, pixel, replicate, …).
#pragma once

#include <cstdint>

namespace umbral {

// The finaliser of SplitMix64 [Steele et al. 2014], David Stafford's variant 13: a bijection of 64 bits.
constexpr std::uint64_t mix64(std::uint64_t x) {
  x ^= x >> 30;
  x *= 0xbf58476d1ce4e5b9ull;
  x ^= x >> 27;
  x *= 0x94d049bb133111ebull;
  x ^= x >> 31;
  return x;
}

// `value` folded into `seed`; the order matters.
constexpr std::uint64_t hash_combine(std::uint64_t seed, std::uint64_t value) {
  return mix64(seed + 0x9e3779b97f4a7c15ull + mix64(value + 0x9e3779b97f4a7c15ull));
}

// The 24 high bits of `x` as a float in [0, 1 − 2⁻²⁴].
constexpr float unit_float(std::uint32_t x) { return static_cast<float>(x >> 8) * 0x1p-24f; }

}  // namespace umbral
