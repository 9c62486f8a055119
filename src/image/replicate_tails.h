// Heavy tails: whether a few rare, bright samples make a mean, so that its error bar cannot be trusted.
#pragma once

#include <span>

#include "core/math.h"

namespace umbral {

// Fewer replicates tell nothing of tails.
inline constexpr int replicates_for_tails = 4;

// Says of a pixel whether its mean hangs on one of R ≥ 4 replicates, a firefly: the brightest, by the sum of its
// channels, lies so far from the others that normal replicates would do it once in 10⁵ pixels [a t test of the one
// left out, R − 2 degrees of freedom, R chances], and moves the mean by more than a twentieth.
//
// (Median and mean that differ by more than three standard errors, as is sometimes proposed, cannot happen: one outlier
// of R moves the standard error as much as the mean, and |median − mean| ≤ √(R − 1) standard errors in any case.)
class FireflyTest {
 public:
  explicit FireflyTest(int replicates);
  bool operator()(std::span<const Vec3d> replicate_means) const;

 private:
  double least_;  // t
};

// How heavy the tails of an image's pixels are: Σ 6/G (mean − median)/Σ standard error over pixels and channels, of G
// groups of a pixel's replicates, 8 to 15 where there are as many. It is about the skewness of the pixels' means [the
// median of numbers with skewness γ lies γ/6 standard deviations below their mean], 0 if they are symmetric. Above
// heavy_tail_index fewer than 93 of 100 intervals of 95 % hold, and the truth is mostly above those that do not, whichever
// the distribution (tests/image, Tails).
struct TailSums {
  double gaps = 0, errors = 0;

  void add(std::span<const Vec3d> replicate_means);
  double index() const { return errors > 0 ? gaps / errors : 0; }
};
inline constexpr double heavy_tail_index = 0.3;

}  // namespace umbral
