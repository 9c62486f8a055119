// Sampler: the stream of random numbers of one sample, a function of (seed, pixel, index) alone.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "core/hash.h"
#include "core/math.h"

namespace umbral {

enum class SamplerKind { independent, sobol };

// The names of the kinds, in the order of SamplerKind.
const std::vector<std::string>& sampler_names();

// Which sample of which pixel. Samples of different replicates are independent of each other; within a replicate
// those of `sobol` are a randomised low-discrepancy set, best at a power of two.
struct SampleId {
  std::uint64_t seed = 0;
  std::uint32_t x = 0, y = 0;
  std::uint32_t replicate = 0;
  std::uint64_t index = 0;  // within the replicate
};

// Building blocks of the Sobol sampler, public for their tests.
namespace sobol {

// The binary digits in reversed order.
constexpr std::uint32_t reversed_bits(std::uint32_t x) {
  x = (x << 16) | (x >> 16);
  x = ((x & 0x00ff00ffu) << 8) | ((x & 0xff00ff00u) >> 8);
  x = ((x & 0x0f0f0f0fu) << 4) | ((x & 0xf0f0f0f0u) >> 4);
  x = ((x & 0x33333333u) << 2) | ((x & 0xccccccccu) >> 2);
  return ((x & 0x55555555u) << 1) | ((x & 0xaaaaaaaau) >> 1);
}

// Generating matrices of the dimensions 2 and 3 by bytes of the index: digits[d][b][v] is the reversed point of
// the index v·256^b.
struct ByteTables {
  std::uint32_t digits[2][4][256];
};
extern const ByteTables tables;

// The second dimension: Pascal's triangle modulo 2 times the index, in five steps [Ahmed 2024].
constexpr std::uint32_t pascal(std::uint32_t v) {
  v ^= (v >> 16);
  v ^= (v & 0xff00ff00u) >> 8;
  v ^= (v & 0xf0f0f0f0u) >> 4;
  v ^= (v & 0xccccccccu) >> 2;
  v ^= (v & 0xaaaaaaaau) >> 1;
  return v;
}

// Dimension 0 … 3 of point `index` of the Sobol sequence, its digits *reversed* (the first one in the lowest bit),
// as the scramble wants them.
inline std::uint32_t reversed_point(std::uint32_t index, std::uint32_t dimension) {
  if (dimension == 0) return index;
  if (dimension == 1) return pascal(index);
  const auto& digits = tables.digits[dimension - 2];
  return digits[0][index & 255u] ^ digits[1][(index >> 8) & 255u] ^ digits[2][(index >> 16) & 255u] ^
         digits[3][index >> 24];
}

// A nested uniform scramble of `x`, whose digits are reversed: each bit is flipped by a hash of the lower ones.
constexpr std::uint32_t scrambled_reversed(std::uint32_t x, std::uint32_t seed) {
  x ^= x * 0x3d20adeau;
  x += seed;
  x *= (seed >> 16) | 1u;
  x ^= x * 0x05526c56u;
  x ^= x * 0x53a22864u;
  return x;
}

}  // namespace sobol

// A value: copy it to replay what it would draw. Numbers are in [0, 1 − 2⁻²⁴].
//
// `sobol` pads sets of four dimensions: each set has its own shuffle of the index [Burley 2020] and its own
// nested uniform scramble [Owen 1995] by hashing [Laine and Karras 2011, with the constants of Vegdahl 2021], so
// there is no end of a table and any number of dimensions may be drawn.
class Sampler {
 public:
  Sampler(SamplerKind kind, const SampleId& id);

  float next1d() { return kind_ == SamplerKind::independent ? next_independent() : next_sobol(); }
  Vec2 next2d();  // both from the same set of four

 private:
  float next_independent();
  float next_sobol();
  void start_set();

  std::uint64_t key_;            // of the pixel and replicate
  std::uint64_t state_ = 0;      // independent: the generator's; sobol: the hash of the running set
  std::uint32_t index_;          // sobol: within the replicate
  std::uint32_t shuffled_ = 0;   // sobol: the index as shuffled for the running set
  std::uint32_t set_ = 0;        // sobol: how many sets were begun
  std::uint32_t dimension_ = 4;  // sobol: the next within the set; 4 asks for a new set
  SamplerKind kind_;
};

// PCG32 [O'Neill 2014]: a 64-bit linear congruential state, permuted on output.
inline float Sampler::next_independent() {
  const std::uint64_t old = state_;
  state_ = old * 6364136223846793005ull + (key_ | 1u);
  const auto xorshifted = static_cast<std::uint32_t>(((old >> 18) ^ old) >> 27);
  const auto rotation = static_cast<std::uint32_t>(old >> 59);
  return unit_float((xorshifted >> rotation) | (xorshifted << ((32 - rotation) & 31u)));
}

inline void Sampler::start_set() {
  state_ = hash_combine(key_, ++set_);
  const auto seed = static_cast<std::uint32_t>(mix64(state_ ^ 0xd1b54a32d192ed03ull));
  const std::uint32_t shuffled = sobol::scrambled_reversed(sobol::reversed_bits(index_), seed);
  shuffled_ = sobol::reversed_bits(shuffled);
  dimension_ = 0;
}

// The seeds of the four scrambles and of the shuffle are 32-bit pieces of hashes: one hash serves a pair.
inline float Sampler::next_sobol() {
  if (dimension_ >= 4) start_set();
  const std::uint32_t dimension = dimension_++;
  if (dimension == 2) state_ = mix64(state_ + 0x632be59bd9b4e019ull);
  const auto seed = static_cast<std::uint32_t>(dimension & 1u ? state_ >> 32 : state_);
  const std::uint32_t digits = sobol::scrambled_reversed(sobol::reversed_point(shuffled_, dimension), seed);
  return unit_float(sobol::reversed_bits(digits));
}

inline Vec2 Sampler::next2d() {
  if (kind_ == SamplerKind::independent) {
    const float x = next_independent();
    const float y = next_independent();
    return {x, y};
  }
  // Pairs are the dimensions (0, 1) or (2, 3); after a single number the pair's other half is skipped.
  if (dimension_ & 1u) ++dimension_;
  const float x = next_sobol();
  const float y = next_sobol();
  return {x, y};
}

}  // namespace umbral
