// EnergyGain: a test that light is not created out of nothing, valid whenever one looks at it.
#pragma once

#include <array>
#include <cstdint>

namespace umbral {

// Of independent numbers X ≥ 0, the hypothesis E X ≤ μ. The wealth of a gambler who bets on X > μ,
//   K_n = mean over k = 1 … 14 of Π_i (1 + 2⁻ᵏ (X_i/μ − 1)),
// is a supermartingale under it, so that P(K ever reaches 1/α) ≤ α [Ville 1939]: it may be watched without end, and
// nothing is asked of the distribution, not even a variance. What it cannot see is a *loss* of energy, for which X
// would need an upper bound.
class EnergyGain {
 public:
  // mean > 0
  explicit EnergyGain(double mean) : mean_(mean) { wealth_.fill(1); }

  // x ≥ 0
  void add(double x);

  double wealth() const;                                  // K_n
  double most() const { return most_; }                   // max over n of K_n
  double p() const { return most_ > 1 ? 1 / most_ : 1; }  // valid at any time
  bool rejects(double alpha) const {
    return p() <= alpha;
  }  // E X > μ, with a chance of at most `alpha` to err
  std::uint64_t count() const { return n_; }

 private:
  static constexpr int bets = 14;
  double mean_;
  std::array<double, bets> wealth_;  // of each bet, times 1
  double most_ = 1;
  std::uint64_t n_ = 0;
};

}  // namespace umbral
