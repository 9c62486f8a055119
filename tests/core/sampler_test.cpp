// The sampler: a function of its SampleId, made of Sobol points, uniform and independent wherever one looks.
#include "core/sampler.h"

#include <array>
#include <bit>
#include <cmath>
#include <functional>
#include <set>
#include <vector>

#include <gtest/gtest.h>

#include "chi_square.h"
#include "support/stability.h"

namespace umbral {
namespace {

constexpr SamplerKind kinds[] = {SamplerKind::independent, SamplerKind::sobol};

// The Sobol sequence by its definition [Joe and Kuo 2008], digit by digit: an independent slow version.
// Dimension 0 is van der Corput's; the others have the primitive polynomials x + 1, x² + x + 1 and x³ + x +
// 1.
class SlowSobol {
 public:
  SlowSobol() {
    fill(0, {}, {});
    fill(1, {1}, {1});
    fill(2, {1, 1}, {1, 3});
    fill(3, {0, 1, 1}, {1, 3, 1});
  }

  // As a 32-bit fraction.
  std::uint32_t point(std::uint32_t index, int dimension) const {
    std::uint32_t x = 0;
    for (int k = 0; k < 32; ++k)
      if ((index >> k) & 1u) x ^= static_cast<std::uint32_t>(m_[dimension][k] << (31 - k));
    return x;
  }

 private:
  // coefficients a₁ … a_s of the polynomial, the last one 1: m_k = 2a₁m_{k−1} ⊕ 4a₂m_{k−2} ⊕ … ⊕ 2ˢm_{k−s} ⊕
  // m_{k−s}
  void fill(int dimension, const std::vector<int>& coefficients, const std::vector<std::uint64_t>& first) {
    const int s = static_cast<int>(coefficients.size());
    std::array<std::uint64_t, 32>& m = m_[dimension];
    for (int k = 0; k < 32; ++k) {
      if (s == 0)
        m[k] = 1;
      else if (k < s)
        m[k] = first[k];
      else {
        m[k] = m[k - s];
        for (int i = 1; i <= s; ++i)
          if (coefficients[i - 1]) m[k] ^= m[k - i] << i;
      }
    }
  }

  std::array<std::uint64_t, 32> m_[4];
};

TEST(Sobol, DigitsAreThoseOfTheDefinition) {
  const SlowSobol slow;
  std::mt19937 random(1);
  for (std::uint32_t i = 0; i < 20'000; ++i) {
    const std::uint32_t index = i < 5000 ? i : static_cast<std::uint32_t>(random());
    for (int d = 0; d < 4; ++d)
      ASSERT_EQ(sobol::reversed_bits(sobol::reversed_point(index, d)), slow.point(index, d))
          << index << ' ' << d;
  }
}

// The first points that Joe and Kuo print for their program; it goes through the indices in Gray code.
TEST(Sobol, FirstPointsAreThePublishedOnes) {
  constexpr double published[10][3] = {{0, 0, 0},
                                       {0.5, 0.5, 0.5},
                                       {0.75, 0.25, 0.25},
                                       {0.25, 0.75, 0.75},
                                       {0.375, 0.375, 0.625},
                                       {0.875, 0.875, 0.125},
                                       {0.625, 0.125, 0.875},
                                       {0.125, 0.625, 0.375},
                                       {0.1875, 0.3125, 0.9375},
                                       {0.6875, 0.8125, 0.4375}};
  for (std::uint32_t i = 0; i < 10; ++i)
    for (int d = 0; d < 3; ++d)
      EXPECT_EQ(sobol::reversed_bits(sobol::reversed_point(i ^ (i >> 1), d)) * 0x1p-32, published[i][d]) << i;
}

// A nested uniform scramble: numbers that agree in exactly their first k digits still do afterwards.
TEST(Sobol, ScrambleIsNested) {
  std::mt19937 random(2);
  for (int i = 0; i < 20'000; ++i) {
    const auto a = static_cast<std::uint32_t>(random()), seed = static_cast<std::uint32_t>(random());
    const int agree = static_cast<int>(random() % 32);
    const std::uint32_t b =
        a ^ (1u << agree) ^ (agree < 31 ? static_cast<std::uint32_t>(random()) << (agree + 1) : 0u);
    const std::uint32_t x = sobol::scrambled_reversed(a, seed), y = sobol::scrambled_reversed(b, seed);
    ASSERT_EQ(std::countr_zero(x ^ y), agree);
  }
}

// The coordinate `dimension` of set `set` of a sample.
float coordinate(SamplerKind kind, const SampleId& id, int set, int dimension) {
  Sampler sampler(kind, id);
  for (int i = 0; i < 4 * set + dimension; ++i) sampler.next1d();
  return sampler.next1d();
}

TEST(Sampler, IsAFunctionOfItsIdAlone) {
  for (const SamplerKind kind : kinds) {
    const SampleId id{7, 3, 4, 2, 11};
    Sampler a(kind, id), b(kind, id);
    for (int i = 0; i < 7; ++i) EXPECT_EQ(a.next1d(), b.next1d());
    Sampler copy = a;  // replays what the original would draw
    for (int i = 0; i < 50; ++i) {
      EXPECT_EQ(a.next2d(), copy.next2d());
      EXPECT_EQ(a.next1d(), copy.next1d());
    }
  }
}

TEST(Sampler, EveryPartOfTheIdMatters) {
  const SampleId ids[] = {{7, 3, 4, 2, 11},
                          {8, 3, 4, 2, 11},
                          {7, 4, 3, 2, 11},
                          {7, 3, 5, 2, 11},
                          {7, 3, 4, 1, 11},
                          {7, 3, 4, 2, 12},
                          {7, 3, 4, 2, 11 + (1ull << 32)}};
  for (const SamplerKind kind : kinds) {
    std::set<float> seen;
    for (const SampleId& id : ids) seen.insert(Sampler(kind, id).next1d());
    EXPECT_EQ(seen.size(), std::size(ids));
  }
}

TEST(Sampler, NamesAreInTheOrderOfTheKinds) {
  EXPECT_EQ(sampler_names()[static_cast<int>(SamplerKind::independent)], "independent");
  EXPECT_EQ(sampler_names()[static_cast<int>(SamplerKind::sobol)], "sobol");
}

// A pair comes from one set: a single number before it wastes the other half of its own pair and no more.
TEST(Sampler, PairsAreNotSplit) {
  const SampleId id{1, 2, 3, 0, 5};
  const auto at = [&](int set, int dimension) { return coordinate(SamplerKind::sobol, id, set, dimension); };
  Sampler sampler(SamplerKind::sobol, id);
  EXPECT_EQ(sampler.next1d(), at(0, 0));
  EXPECT_EQ(sampler.next2d(), Vec2(at(0, 2), at(0, 3)));
  EXPECT_EQ(sampler.next2d(), Vec2(at(1, 0), at(1, 1)));
  EXPECT_EQ(sampler.next1d(), at(1, 2));
  EXPECT_EQ(sampler.next2d(), Vec2(at(2, 0), at(2, 1)));
}

// 2^m points of a replicate, in any set: every elementary interval in base 2 of volume 2^−m of the first two
// dimensions holds exactly one, and so does every 1/2^m of each of the four.
TEST(Sampler, SobolPairsAreNets) {
  for (const int m : {3, 6, 10})
    for (int set = 0; set < 3; ++set) {
      const std::uint32_t n = 1u << m;
      std::vector<std::array<std::uint32_t, 4>> points(n);
      for (std::uint32_t i = 0; i < n; ++i)
        for (int d = 0; d < 4; ++d) {
          const float x = coordinate(SamplerKind::sobol, {9, 5, 6, 1, i + 3ull * n}, set, d);
          points[i][d] = static_cast<std::uint32_t>(x * 0x1p24f);
        }
      for (int split = 0; split <= m; ++split) {
        std::vector<int> counts(n);
        for (const auto& p : points)
          if (split < m)
            ++counts[((p[0] >> (24 - split)) << (m - split)) | (p[1] >> (24 - (m - split)))];
          else
            ++counts[p[0] >> (24 - m)];
        for (const int count : counts) ASSERT_EQ(count, 1) << m << ' ' << split;
      }
      for (int d = 0; d < 4; ++d) {
        std::set<std::uint32_t> strata;
        for (const auto& p : points) strata.insert(p[d] >> (24 - m));
        EXPECT_EQ(strata.size(), n) << m << ' ' << d;
      }
    }
}

TEST(Sampler, StaysBelowOne) {
  for (const SamplerKind kind : kinds) {
    float largest = 0;
    for (std::uint64_t i = 0; i < 300; ++i) {
      Sampler sampler(kind, {1, 0, 0, 0, i});
      for (int d = 0; d < 10'000; ++d) {
        const float u = sampler.next1d();
        ASSERT_GE(u, 0);
        ASSERT_LE(u, one_minus_epsilon);
        largest = std::max(largest, u);
      }
    }
    EXPECT_GT(largest, 1 - 1e-5f);
  }
}

// Dimension 10 000: still one point in every 1024th.
TEST(Sampler, SobolHasNoLastDimension) {
  std::array<std::set<int>, 4> strata;
  for (std::uint64_t i = 0; i < 1024; ++i) {
    Sampler sampler(SamplerKind::sobol, {1, 2, 3, 4, i});
    for (int d = 0; d < 9996; ++d) sampler.next1d();
    for (std::set<int>& set : strata) set.insert(static_cast<int>(sampler.next1d() * 1024));
  }
  for (const std::set<int>& set : strata) EXPECT_EQ(set.size(), 1024u);
  test::record({"Accumulation", "Sobol points end or repeat at dimension 10 000",
                "1024 strata each hold one of 1024", fmt::format("{}", strata[3].size()), "pbrt-v3 #237"});
}

TEST(Sampler, GoesOnBeyondTheLast32BitIndex) {
  constexpr std::uint64_t end = 1ull << 32;
  for (const SamplerKind kind : kinds) {
    test::UniformSquareTest uniform;
    std::set<Vec2, decltype([](Vec2 a, Vec2 b) { return a.x != b.x ? a.x < b.x : a.y < b.y; })> seen;
    for (std::uint64_t i = end - 20'000; i < end + 20'000; ++i) {
      const Vec2 u = Sampler(kind, {5, 1, 1, 0, i}).next2d();
      uniform.add(u.x, u.y);
      seen.insert(u);
    }
    // A net is more even than chance: p near 1 is as it should be, near 0 is not.
    EXPECT_GT(uniform.p(), 1e-4);
    EXPECT_GT(seen.size(), 39'990u);
    test::record({"Accumulation",
                  "samples repeat about index 2^32: " + sampler_names()[static_cast<std::size_t>(kind)],
                  "> 39990 of 40000 differ", std::to_string(seen.size())});
    for (const std::uint64_t i : {end, end + 1})
      EXPECT_NE(Sampler(kind, {5, 1, 1, 0, i}).next1d(), Sampler(kind, {5, 1, 1, 0, i - end}).next1d());
  }
}

// Two numbers that should be independent, drawn for each of 300 000 pixels: their pairs fill the square
// evenly.
double independence_p(const std::function<std::pair<float, float>(std::uint32_t x, std::uint32_t y)>& draw) {
  test::UniformSquareTest uniform;
  for (std::uint32_t pixel = 0; pixel < 300'000; ++pixel) {
    const auto [a, b] = draw(pixel % 1000, pixel / 1000);
    uniform.add(a, b);
  }
  return uniform.p();
}

TEST(Sampler, PixelsReplicatesSeedsSetsAndIndicesAreIndependent) {
  using Pair = std::pair<float, float>;
  for (const SamplerKind kind : kinds) {
    const auto first = [&](const SampleId& id) { return Sampler(kind, id).next1d(); };
    const auto expect = [&](const char* what, const auto& draw) {
      EXPECT_GT(independence_p(draw), 1e-4) << what;
    };
    expect("pixels side by side", [&](std::uint32_t x, std::uint32_t y) {
      return Pair{first({1, 2 * x, y, 0, 0}), first({1, 2 * x + 1, y, 0, 0})};
    });
    expect("pixels above each other", [&](std::uint32_t x, std::uint32_t y) {
      return Pair{first({1, x, 2 * y, 0, 3}), first({1, x, 2 * y + 1, 0, 3})};
    });
    expect("mirrored pixels", [&](std::uint32_t x, std::uint32_t y) {
      return Pair{first({1, x, y + 2000, 0, 0}), first({1, y + 2000, x, 0, 0})};
    });
    expect("replicates", [&](std::uint32_t x, std::uint32_t y) {
      return Pair{first({1, x, y, 0, 5}), first({1, x, y, 1, 5})};
    });
    expect("seeds", [&](std::uint32_t x, std::uint32_t y) {
      return Pair{first({1, x, y, 0, 5}), first({2, x, y, 0, 5})};
    });
    expect("sets", [&](std::uint32_t x, std::uint32_t y) {
      return Pair{coordinate(kind, {1, x, y, 0, 5}, 0, 0), coordinate(kind, {1, x, y, 0, 5}, 1, 0)};
    });
    expect("indices 2³² apart", [&](std::uint32_t x, std::uint32_t y) {
      return Pair{first({1, x, y, 0, 5}), first({1, x, y, 0, 5 + (1ull << 32)})};
    });
    for (int d = 0; d < 4; ++d)
      for (int e = 0; e < d; ++e)
        expect("dimensions of a set", [&](std::uint32_t x, std::uint32_t y) {
          return Pair{coordinate(kind, {1, x, y, 0, 0}, 0, d), coordinate(kind, {1, x, y, 0, 0}, 0, e)};
        });
  }
}

}  // namespace
}  // namespace umbral
