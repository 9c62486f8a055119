// Integrals over the torus that are known in closed form: area, volume, Crofton's counts and lengths.
#include <gtest/gtest.h>

#include "core/statistics.h"
#include "scene/shapes/rays.h"
#include "support/stability.h"

namespace umbral::test {
namespace {

class TorusIdentities : public testing::TestWithParam<double> {
 protected:
  Torus torus() const { return torus_of(GetParam()); }
  double a() const { return ratio_of(torus()); }

  // ∮ f(point) |dA| or, signed, the same with the area beyond a spindle's axis counted as negative.
  template <class F>
  auto integral(F f, bool is_signed) const {
    const int n_u = 8, n_v = 4000;
    decltype(f(SurfacePoint{})) sum{};
    for (int i = 0; i < n_u; ++i)
      for (int j = 0; j < n_v; ++j) {
        const SurfacePoint point = torus().at({(i + 0.5) / n_u, (j + 0.5) / n_v});
        const double area = dot(cross(point.dpdu, point.dpdv), point.n) / (n_u * n_v);
        sum += f(point) * (is_signed ? area : std::abs(area));
      }
    return sum;
  }
};

INSTANTIATE_TEST_SUITE_P(Ratios, TorusIdentities, testing::Values(0.05, 0.25, 0.75, 1.0, 1.5, 4.0));

TEST_P(TorusIdentities, ImplicitEquationHolds) {
  Random random(1);
  for (int i = 0; i < 10000; ++i) {
    const Vec3d p = torus().at(random.square()).p;
    const double left = sqr(dot(p, p) + 1 - a() * a()), right = 4 * (p.x * p.x + p.y * p.y);
    EXPECT_NEAR(left, right, 4e-15 * std::pow(1 + a(), 3));  // a few roundings of p², times 2 p²
  }
}

TEST_P(TorusIdentities, AreaIsThatOfTheUnrolledTubeAndOfTheSpindlesInnerSheet) {
  const double unrolled = 4 * pi_d * pi_d * a();
  // A spindle has more: it counts 1 + a cos ψ by its size. Its signed area is still that of the tube.
  const double s = std::sqrt(std::max(0.0, a() * a() - 1)), excess = 8 * pi_d * a() * (s - std::atan(s));
  EXPECT_NEAR(torus().area() / (unrolled + excess), 1, 4e-16);
  const auto one = [](const SurfacePoint&) { return 1.0; };
  EXPECT_NEAR(integral(one, true) / unrolled, 1, 1e-12);
  EXPECT_NEAR(integral(one, false) / torus().area(), 1, 1e-6);
}

TEST_P(TorusIdentities, NormalsCancel) {
  const auto normal = [](const SurfacePoint& point) { return point.n; };
  EXPECT_LT(glm::length(integral(normal, true)), 1e-12);
  EXPECT_LT(glm::length(integral(normal, false)), 1e-12 * (1 + a()) * (1 + a()));
}

// ⅓ ∮ p·n dA = 2π²a². For a spindle that is the volume between its sheets.
TEST_P(TorusIdentities, VolumeByTheDivergenceTheorem) {
  const double volume = integral([](const SurfacePoint& point) { return dot(point.p, point.n) / 3; }, true);
  EXPECT_NEAR(volume / (2 * pi_d * pi_d * a() * a()), 1, 1e-12);
}

void expect_mean(const Moments& moments, double expected) {
  // A right mean fails one such test in 15 000; one off by 1 % is found with probability 0.9 or more.
  EXPECT_LT(std::abs(moments.mean - expected), 4 * moments.standard_error());
  EXPECT_LT((4 + 1.29) * moments.standard_error(), 0.01 * expected) << "too few rays";
}

// Isotropic lines through the ball of radius 1 + a cross a surface of area S 2S/S_ball times on average
// [Cauchy 1850; Crofton 1868], and are within a body of volume V for 4V/S_ball.
TEST_P(TorusIdentities, CroftonCountsAndLengths) {
  Random random(2);
  Moments hits, lengths;
  const int n = a() < 0.1 ? 3000000 : a() < 0.5 ? 1000000 : 300000;
  for (int i = 0; i < n; ++i) {
    const std::vector<double> t = crossings(torus(), random.isotropic_line(1 + a()));
    ASSERT_EQ(t.size() % 2, 0u) << "ray " << i;
    ASSERT_LE(t.size(), a() > 1 ? 6u : 4u);
    double length = 0;
    for (std::size_t k = 0; k < t.size(); k += 2) length += t[k + 1] - t[k];
    hits.add(static_cast<double>(t.size()));
    lengths.add(length);
  }
  const double ball = 4 * pi_d * sqr(1 + a());
  expect_mean(hits, 2 * torus().area() / ball);
  expect_mean(lengths, 2 * pi_d * a() * a() / sqr(1 + a()));
  const auto off = [](const Moments& moments, double expected) {
    return fmt::format("{:+.2f} ± {:.2f} %", 100 * (moments.mean / expected - 1),
                       100 * moments.standard_error() / expected);
  };
  record({"Solvers",
          fmt::format(
              "isotropic lines cross a torus of r = {:g} R, or are within it, other than Crofton says", a()),
          "equal within 4 σ, 1 % would show; never an odd number",
          "crossings " + off(hits, 2 * torus().area() / ball) + ", lengths " +
              off(lengths, 2 * pi_d * a() * a() / sqr(1 + a()))});
}

TEST(Torus, IsPlacedByItsRadii) {
  const Torus torus{4, 2};
  EXPECT_EQ(torus.placement().point({0, -1.5, 0.5}), Vec3d(0, -6, 2));
  EXPECT_EQ(torus.at({0, 0}).p, Vec3d(1.5, 0, 0));
  EXPECT_LT(glm::length(torus.at({0.25, 0.25}).p - Vec3d(0, 1, 0.5)), 1e-15);
}

}  // namespace
}  // namespace umbral::test
