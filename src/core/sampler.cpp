// The independent generator and the padded, shuffled, Owen-scrambled Sobol sequence.
#include "core/sampler.h"

namespace umbral {
namespace sobol {
namespace {

// Recurrence and direction numbers from Joe and Kuo [2008]: x²+x+1, m = 1 3 and x³+x+1, m = 1 3 1.
struct Polynomial {
  int degree;
  std::uint32_t coefficients;  // the inner ones, a₁ … a_{s−1}, first in the highest bit
  std::array<std::uint32_t, 3> m;
};

constexpr std::array<std::uint32_t, 32> direction_numbers(const Polynomial& polynomial) {
  std::array<std::uint32_t, 32> v{};
  const int s = polynomial.degree;
  for (int i = 0; i < 32; ++i) {
    if (i < s) {
      v[i] = polynomial.m[i] << (31 - i);
      continue;
    }
    v[i] = v[i - s] ^ (v[i - s] >> s);
    for (int k = 1; k < s; ++k)
      if ((polynomial.coefficients >> (s - 1 - k)) & 1u) v[i] ^= v[i - k];
  }
  return v;
}

constexpr ByteTables make_tables() {
  constexpr Polynomial polynomials[2] = {{2, 1, {1, 3, 0}}, {3, 1, {1, 3, 1}}};
  ByteTables tables{};
  for (int d = 0; d < 2; ++d) {
    const std::array<std::uint32_t, 32> directions = direction_numbers(polynomials[d]);
    for (int byte = 0; byte < 4; ++byte)
      for (std::uint32_t bit = 0; bit < 8; ++bit)
        for (std::uint32_t value = 0; value < (1u << bit); ++value)
          tables.digits[d][byte][value | (1u << bit)] =
              tables.digits[d][byte][value] ^ reversed_bits(directions[8 * byte + static_cast<int>(bit)]);
  }
  return tables;
}

}  // namespace

constexpr ByteTables tables = make_tables();

}  // namespace sobol

const std::vector<std::string>& sampler_names() {
  static const std::vector<std::string> names{"independent", "sobol"};
  return names;
}

Sampler::Sampler(SamplerKind kind, const SampleId& id)
    : key_(hash_combine(hash_combine(id.seed, (std::uint64_t{id.y} << 32) | id.x),
                        (std::uint64_t{id.replicate} << 32) | (id.index >> 32))),
      index_(static_cast<std::uint32_t>(id.index)),
      kind_(kind) {
  // Beyond 2³² samples a replicate goes on with a fresh scramble: key_ holds the high half of the index.
  if (kind_ == SamplerKind::independent) state_ = hash_combine(key_, index_);
}

}  // namespace umbral
