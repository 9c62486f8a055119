// Films filled with numbers whose distribution is known, and the bounds of counts.
#pragma once

#include <random>
#include <utility>
#include <vector>

#include <boost/math/distributions/binomial.hpp>

#include "image/film.h"

namespace umbral::test {

inline double true_mean(int x, int y, int c) { return 1 + 0.25 * x + 0.5 * y + 0.125 * c; }

// Adds `samples` to every replicate of every pixel; the means of the replicates are normal around true_mean()
// with the standard deviation `sigma`.
inline void add_normal_block(Film& film, std::uint32_t samples, double sigma, std::mt19937_64& random) {
  const FilmLayout& layout = film.layout();
  std::normal_distribution<double> normal;
  std::vector<Spectrum> sums(layout.replicates, black);
  const std::vector<Spectrum> layers(layout.layers.size(), Spectrum(static_cast<float>(samples)));
  for (int y = layout.y0; y < layout.y1; ++y)
    for (int x = layout.x0; x < layout.x1; ++x) {
      for (Spectrum& sum : sums)
        for (int c = 0; c < 3; ++c)
          sum[c] = static_cast<float>(samples * (true_mean(x, y, c) + sigma * normal(random)));
      film.add(x, y, {sums, samples, layers, {}});
    }
}

// The counts that a Binomial(n, p) has with probability 1 − 2·10⁻⁴: tests use fixed seeds, so that this is
// the probability with which a right program had to be given another seed.
inline std::pair<double, double> binomial_bounds(double n, double p) {
  const boost::math::binomial distribution(n, p);
  return {boost::math::quantile(distribution, 1e-4),
          boost::math::quantile(boost::math::complement(distribution, 1e-4))};
}

}  // namespace umbral::test
