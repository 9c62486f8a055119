// What holds for every analytic shape: its parametrisation, normals, area, sampling and hits agree.
#include <gtest/gtest.h>
#include <boost/math/distributions/chi_squared.hpp>

#include "scene/shapes/rays.h"
#include "scene/shapes/shapes.h"

namespace umbral::test {
namespace {

struct Case {
  const char* name;
  AnalyticShape shape;
};

void PrintTo(const Case& c, std::ostream* out) { *out << c.name; }

class Parametrisation : public testing::TestWithParam<Case> {
 protected:
  SurfacePoint at(const glm::dvec2& uv) const {
    return std::visit([&](const auto& s) { return s.at(uv); }, GetParam().shape);
  }
  SurfacePoint nearest(const Vec3d& p) const {
    return std::visit([&](const auto& s) { return s.nearest(p); }, GetParam().shape);
  }
  SurfacePoint sample(const Vec2& u) const {
    return std::visit([&](const auto& s) { return s.sample(u); }, GetParam().shape);
  }
  double area() const {
    return std::visit([&](const auto& s) { return s.area(); }, GetParam().shape);
  }
  Bounds bounds() const {
    return std::visit([&](const auto& s) { return s.bounds(); }, GetParam().shape);
  }
  // The lengths of the shape: 1 for its radius, more for a spindle's.
  double size() const { return std::max(1.0, bounds().high.x); }
  bool is_disk() const { return std::holds_alternative<Disk>(GetParam().shape); }

  static double stretch(const SurfacePoint& point) { return glm::length(cross(point.dpdu, point.dpdv)); }
  // Probability of each cell of a grid over uv under sampling uniform by area.
  std::vector<double> cell_areas(int cells) const;
  // The p-value of a χ² test of `draw` (from random numbers to uv) against uniformity by area.
  template <class Draw>
  double p_of_uniformity(Draw draw) const;
};

// Where uv is not uniform by area.
class UnevenParametrisation : public Parametrisation {};

std::string name_of(const testing::TestParamInfo<Case>& info) { return info.param.name; }

const auto uneven =
    testing::Values(Case{"sphere", Sphere{}}, Case{"disk", Disk{}}, Case{"torus_ring", torus_of(0.25)},
                    Case{"torus_thick", torus_of(0.875)}, Case{"torus_horn", torus_of(1)},
                    Case{"torus_spindle", torus_of(1.3)}, Case{"torus_wide_spindle", torus_of(8)});
const auto even_to_one_in_a_thousand =
    testing::Values(Case{"torus_thin", torus_of(1e-3)}, Case{"cylinder", Cylinder{}});

INSTANTIATE_TEST_SUITE_P(Uneven, UnevenParametrisation, uneven, name_of);
INSTANTIATE_TEST_SUITE_P(Shapes, Parametrisation, uneven, name_of);
INSTANTIATE_TEST_SUITE_P(Even, Parametrisation, even_to_one_in_a_thousand, name_of);

TEST_P(Parametrisation, TangentsAreDerivatives) {
  Random random(1);
  for (int i = 0; i < 1000; ++i) {
    const glm::dvec2 uv = 0.01 + 0.98 * random.square();
    const double h = 1e-5;  // truncation (2π)³ h²/6 = 4e-9, rounding ε/h = 2e-11
    const Vec3d du = (at({uv.x + h, uv.y}).p - at({uv.x - h, uv.y}).p) / (2 * h);
    const Vec3d dv = (at({uv.x, uv.y + h}).p - at({uv.x, uv.y - h}).p) / (2 * h);
    const SurfacePoint point = at(uv);
    EXPECT_LT(glm::length(du - point.dpdu), 1e-8 * size());
    EXPECT_LT(glm::length(dv - point.dpdv), 1e-8 * size());
  }
}

TEST_P(Parametrisation, NormalIsTheCrossProductOfTangents) {
  Random random(2);
  for (int i = 0; i < 1000; ++i) {
    const SurfacePoint point = at(random.square());
    EXPECT_NEAR(glm::length(point.n), 1, 4e-16);
    if (stretch(point) < 1e-3) continue;
    // Beyond the axis a spindle's u runs the other way around; the disk's u turns against its normal.
    const Vec3d n = cross(point.dpdu, point.dpdv) / stretch(point);
    const double sense = is_disk() ? -1 : 1;
    const double across =
        dot(point.dpdu, Vec3d(-std::sin(2 * pi_d * point.uv.x), std::cos(2 * pi_d * point.uv.x), 0));
    EXPECT_LT(glm::length(n - std::copysign(1.0, across) * sense * point.n), 1e-13);
  }
}

TEST_P(Parametrisation, NearestFindsTheUvOfAPoint) {
  Random random(3);
  for (int i = 0; i < 5000; ++i) {
    const SurfacePoint point = at(0.001 + 0.998 * random.square());
    if (stretch(point) < 0.01) continue;
    // Off the surface by less than it bends, and for the flat disk by any length.
    const double off = is_disk() ? random.uniform(-1, 1) : random.uniform(-1e-7, 1e-7);
    const SurfacePoint found = nearest(point.p + off * point.n);
    EXPECT_LT(glm::length(found.p - point.p), 4e-15 * size());
    EXPECT_LT(glm::length(found.n - point.n), 4e-12);
    EXPECT_LT(glm::length(found.uv - point.uv), 1e-12);
    EXPECT_LT(glm::length(found.dpdu - point.dpdu), 1e-11 * size());
    EXPECT_LT(glm::length(found.dpdv - point.dpdv), 1e-11 * size());
  }
}

TEST_P(Parametrisation, NearestIsFiniteEverywhere) {
  for (const double x : {-2.0, -1.0, -0.0, 0.0, 1.0})
    for (const double y : {-1.0, -0.0, 0.0})
      for (const double z : {-1.0, -0.0, 0.0, 2.0}) {
        const SurfacePoint point = nearest({x, y, z});
        for (int i = 0; i < 3; ++i) EXPECT_TRUE(std::isfinite(point.p[i] + point.dpdu[i] + point.dpdv[i]));
        EXPECT_NEAR(glm::length(point.n), 1, 4e-16);
        for (int i = 0; i < 2; ++i) EXPECT_TRUE(point.uv[i] >= 0 && point.uv[i] <= 1);
        EXPECT_LT(glm::length(at(point.uv).p - point.p), 1e-14 * size());
      }
}

TEST_P(Parametrisation, BoundsAreTight) {
  Vec3d low(1e30), high(-1e30);
  for (int i = 0; i <= 64; ++i)
    for (int j = 0; j <= 64; ++j) {
      const Vec3d p = at({i / 64.0, j / 64.0}).p;
      low = glm::min(low, p);
      high = glm::max(high, p);
    }
  EXPECT_LT(glm::length(low - bounds().low), 1e-14 * size());
  EXPECT_LT(glm::length(high - bounds().high), 1e-14 * size());
}

TEST_P(Parametrisation, AreaIsTheIntegralOfTheCrossProduct) {
  const int n =
      20000;  // along v; nothing depends on u but by rotation. The rule's error is below (2π)²/(24 n²)
  double sum = 0;
  for (int j = 0; j < n; ++j) sum += stretch(at({0.3, (j + 0.5) / n})) / n;
  EXPECT_NEAR(sum / area(), 1, 1e-8);
}

TEST_P(Parametrisation, RaysHitThePointsOfTheParametrisation) {
  Random random(4);
  int compared = 0;
  for (int i = 0; i < 5000; ++i) {
    const SurfacePoint point = at(random.square());
    const double distance = random.uniform(4, 8) * size();
    DoubleRay ray{point.p, random.direction()};
    ray.o -= distance * ray.d;
    if (std::abs(dot(ray.d, point.n)) < 0.01 || stretch(point) < 1e-6) continue;
    const auto found = std::visit([&](const auto& s) { return crossings(s, ray); }, GetParam().shape);
    double error = unbounded;
    for (const double t : found) error = std::min(error, std::abs(t - distance));
    EXPECT_LT(error, 1e-12 * size()) << i;
    ++compared;
  }
  EXPECT_GT(compared, 4500);
}

std::vector<double> Parametrisation::cell_areas(int cells) const {
  std::vector<double> areas;
  const int steps = 400;
  for (int j = 0; j < cells; ++j) {
    double sum = 0;
    for (int k = 0; k < steps; ++k) sum += stretch(at({0, (j + (k + 0.5) / steps) / cells}));
    for (int i = 0; i < cells; ++i) areas.push_back(sum / (steps * cells * cells * area()));
  }
  return areas;
}

template <class Draw>
double Parametrisation::p_of_uniformity(Draw draw) const {
  const int cells = 16, n = 500000;
  Random random(5);
  std::vector<double> counts(cells * cells);
  for (int k = 0; k < n; ++k) {
    const glm::dvec2 uv = draw(random.float_square());
    const int i = std::min(cells - 1, static_cast<int>(uv.x * cells));
    const int j = std::min(cells - 1, static_cast<int>(uv.y * cells));
    counts[static_cast<std::size_t>(j * cells + i)] += 1;
  }
  const std::vector<double> expected = cell_areas(cells);
  double chi2 = 0;
  for (std::size_t c = 0; c < counts.size(); ++c)
    chi2 += sqr(counts[c] - n * expected[c]) / (n * expected[c]);
  return cdf(complement(boost::math::chi_squared(cells * cells - 1), chi2));
}

// Power: 255 degrees of freedom and n = 5e5 reject densities that are off by 2 % (root mean square over the
// cells) with probability 0.99.
TEST_P(Parametrisation, SamplesAreUniformByArea) {
  EXPECT_GT(p_of_uniformity([&](const Vec2& u) { return sample(u).uv; }), 1e-4);
}

// The same test with samples that are uniform by uv instead, to show that it can fail.
TEST_P(UnevenParametrisation, SamplesUniformByUvAreRejected) {
  EXPECT_LT(p_of_uniformity([&](const Vec2& u) { return glm::dvec2(u); }), 1e-12);
}

TEST_P(Parametrisation, SamplesAtTheEdgesOfTheSquareAreOnTheShape) {
  for (const float u : {0.0f, 0x1p-24f, 0.5f, one_minus_epsilon})
    for (const float v : {0.0f, 0x1p-24f, 0.5f, one_minus_epsilon}) {
      const SurfacePoint point = sample({u, v});
      EXPECT_LT(glm::length(nearest(point.p).p - point.p), 1e-14 * size());
      EXPECT_LT(glm::length(at(point.uv).p - point.p), 1e-14 * size());
      for (int i = 0; i < 2; ++i) EXPECT_TRUE(point.uv[i] >= 0 && point.uv[i] <= 1);
    }
}

}  // namespace
}  // namespace umbral::test
