// Integer hashing.
#include "core/hash.h"

#include <bit>
#include <cmath>
#include <set>

#include <gtest/gtest.h>

namespace umbral {
namespace {

TEST(Hash, Mix64IsTheFinaliserOfSplitMix64) {
  // The published outputs of SplitMix64 seeded with 1234567: its n-th is mix64(seed + n·golden ratio).
  constexpr std::uint64_t golden = 0x9e3779b97f4a7c15ull;
  EXPECT_EQ(mix64(1234567 + golden), 6457827717110365317ull);
  EXPECT_EQ(mix64(1234567 + 2 * golden), 3203168211198807973ull);
  EXPECT_EQ(mix64(1234567 + 3 * golden), 9817491932198370423ull);
}

// Flipping any bit of the input flips each bit of the output with probability ½: of 64·64 pairs, each counted
// over 4000 inputs, none is further off than 5.5 sigma (probability 1.6e-4 of failing, were the seed
// another).
template <class F>
double worst_avalanche(F&& hash) {
  constexpr int n = 4000;
  double worst = 0;
  for (int in = 0; in < 64; ++in) {
    int flips[64] = {};
    for (std::uint64_t i = 0; i < n; ++i) {
      const std::uint64_t x = mix64(i) + i;
      const std::uint64_t changed = hash(x) ^ hash(x ^ (1ull << in));
      for (int out = 0; out < 64; ++out) flips[out] += static_cast<int>((changed >> out) & 1);
    }
    for (const int count : flips) worst = std::max(worst, std::abs(count - n / 2.0) / std::sqrt(n / 4.0));
  }
  return worst;
}

TEST(Hash, EveryBitDependsOnEveryBit) {
  EXPECT_LT(worst_avalanche([](std::uint64_t x) { return hash_combine(x, 5); }), 5.5);
  EXPECT_LT(worst_avalanche([](std::uint64_t x) { return hash_combine(5, x); }), 5.5);
}

TEST(Hash, OrderMattersAndSmallNumbersDoNotCollide) {
  EXPECT_NE(hash_combine(1, 2), hash_combine(2, 1));
  std::set<std::uint64_t> seen;
  for (std::uint64_t a = 0; a < 300; ++a)
    for (std::uint64_t b = 0; b < 300; ++b) seen.insert(hash_combine(a, b));
  EXPECT_EQ(seen.size(), 90'000u);
}

TEST(Hash, UnitFloatIsBelowOne) {
  EXPECT_EQ(unit_float(0), 0.0f);
  EXPECT_EQ(unit_float(255), 0.0f);
  EXPECT_EQ(unit_float(256), 0x1p-24f);
  EXPECT_EQ(unit_float(0x80000000u), 0.5f);
  EXPECT_EQ(unit_float(0xffffffffu), 0x1.fffffep-1f);
}

}  // namespace
}  // namespace umbral
