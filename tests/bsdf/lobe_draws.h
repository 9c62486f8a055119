// Directions that a lobe draws, and how many of them its density puts where.
#pragma once

#include <optional>
#include <vector>

#include "bsdf/bsdf.h"
#include "support/chi_square.h"
#include "support/random.h"
#include "support/sphere_cells.h"

namespace umbral::test {

template <class Lobe>
std::optional<BsdfSample> draw(const Lobe& lobe, const Vec3& wo, Random& random) {
  const float u1 = random.number();
  const Vec2 u2 = random.square();
  return lobe.sample(wo, u1, u2);
}

// Cells for the directions that the lobe scatters wo to, but for its mirror-like part, from that many draws.
template <class Lobe>
SphereCells cells_of(const Lobe& lobe, const Vec3& wo, Random& random, int draws = 1 << 12) {
  std::vector<Vec3> pilot;
  for (int i = 0; i < draws; ++i)
    if (const auto sample = draw(lobe, wo, random); sample && !sample->delta) pilot.push_back(sample->wi);
  return {pilot, 32};
}

// Draws by cell, the last one for those without a density; and as many as the density expects, but for the last.
struct CountedDraws {
  std::vector<double> observed, expected;
  double total = 0;  // of the density over all cells

  // With the draws that `of_all` of the density leaves over.
  ChiSquare chi_square(int draws, double of_all) {
    expected.back() = draws * std::max(0.0, 1 - of_all);
    return test::chi_square(observed, expected);
  }
};

template <class Lobe>
CountedDraws counted_draws(const Lobe& lobe, const Vec3& wo, Random& random, int draws) {
  const SphereCells cells = cells_of(lobe, wo, random);
  CountedDraws counted{std::vector<double>(cells.size() + 1), std::vector<double>(cells.size() + 1)};
  for (int i = 0; i < draws; ++i) {
    const auto sample = draw(lobe, wo, random);
    ++counted.observed[sample && !sample->delta ? cells.find(sample->wi) : cells.size()];
  }
  for (std::size_t i = 0; i < cells.size(); ++i) {
    const double mass = cells.integral_of(i, [&](const Vec3& wi) { return lobe.pdf(wo, wi); });
    counted.expected[i] = draws * mass;
    counted.total += mass;
  }
  return counted;
}

}  // namespace umbral::test
