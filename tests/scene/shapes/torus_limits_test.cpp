// Where torus solvers fail: far origins, thin tubes, grazing rays, starts on the surface, the axis.
#include <gtest/gtest.h>

#include "scene/shapes/rays.h"
#include "support/stability.h"

namespace umbral::test {
namespace {

struct Far {
  double ratio, distance;
};

class FarTorus : public testing::TestWithParam<Far> {};

INSTANTIATE_TEST_SUITE_P(Distances, FarTorus,
                         testing::Values(Far{0.25, 50}, Far{0.25, 500}, Far{0.25, 5000}, Far{0.25, 1e8},
                                         Far{1e-3, 50}, Far{1e-3, 5000}, Far{1e-3, 5e4}, Far{1e-5, 500},
                                         Far{1, 5e4}, Far{1.5, 5e4}));

// Every ray passes well within the tube, so that none may miss. The error is that of the last digit of t.
TEST_P(FarTorus, NoRayMissesAndNoHitIsBad) {
  const auto [ratio, distance] = GetParam();
  const Torus torus = torus_of(ratio);
  const double a = ratio_of(torus);
  Random random(1);
  double worst = 0;
  for (int i = 0; i < 30000; ++i) {
    const double phi = random.uniform(0, 2 * pi_d);
    const Vec3d target =
        Vec3d(std::cos(phi), std::sin(phi), 0) + 0.9 * a * random.uniform() * random.direction();
    DoubleRay ray{target, random.direction()};
    ray.o -= distance * ray.d;
    const auto t = torus.intersect(ray.o, ray.d, 0, unbounded);
    ASSERT_TRUE(t);
    EXPECT_LT(*t, distance);
    const double error = distance_to_torus(a, ray, *t);
    EXPECT_LE(error, 1.2e-16 * distance + 2e-15 * (1 + a));
    worst = std::max(worst, error / a);
  }
  const bool promised = distance <= 5e4 && a >= 1e-3;
  if (promised) {
    EXPECT_LE(worst, 1e-8);
  }
  record({"Solvers",
          fmt::format("a torus of r = {:g} R is missed or hit badly from {:g} R away", ratio, distance),
          promised ? "0 misses, error ≤ 1e-8 r" : "0 misses, error of the last digit of t",
          fmt::format("0 of 30000, {:.1e} r", worst), "POV-Ray PR #358"});
}

// The same ray with its origin next to the torus: no crossing appears, vanishes or moves.
TEST_P(FarTorus, CrossingsAreThoseOfTheNearRay) {
  const auto [ratio, distance] = GetParam();
  const Torus torus = torus_of(ratio);
  const double a = ratio_of(torus), shift = distance - 4 * (1 + a);
  Random random(2);
  for (int i = 0; i < 20000; ++i) {
    DoubleRay far = random.isotropic_line(1 + a);
    far.o -= distance * far.d;
    DoubleRay near = far;
    for (int k = 0; k < 3; ++k) near.o[k] = std::fma(shift, far.d[k], far.o[k]);
    const auto t_far = crossings(torus, far), t_near = crossings(torus, near);
    ASSERT_EQ(t_far.size(), t_near.size()) << i;
    for (std::size_t k = 0; k < t_far.size(); ++k)
      EXPECT_NEAR(t_far[k] - shift, t_near[k], 4e-16 * distance + 1e-9) << i;  // 1e-9: rays that graze
  }
}

// By the normal curvature κ = cos²α/a + sin²α cos ψ/(1 + a cos ψ), a chord that dips h below the surface is 2
// √(2h/κ) long. The outer half of a ring lies on its convex hull, so that a line above a tangent misses it
// all.
TEST(TorusLimits, GrazingRaysHitTwiceBelowTheSurfaceAndNeverAbove) {
  Random random(3);
  for (const double ratio : {1e-3, 0.25, 0.75})
    for (int i = 0; i < 20000; ++i) {
      const Torus torus = torus_of(ratio);
      const double a = ratio_of(torus);
      const double psi = random.uniform(-1, 1);
      const SurfacePoint point = torus.at({random.uniform(), psi / (2 * pi_d)});
      const Vec3d along_v = glm::normalize(point.dpdv), d = random.tangent(point.n);
      const double cosine2 = sqr(dot(d, along_v));
      const double curvature = cosine2 / a + (1 - cosine2) * std::cos(psi) / (1 + a * std::cos(psi));
      const double h = a * random.power_of_ten(-9, -4);
      DoubleRay ray{point.p + h * point.n - 3.0 * d, d};
      EXPECT_TRUE(crossings(torus, ray).empty());
      ray.o -= 2 * h * point.n;
      const auto t = crossings(torus, ray);
      ASSERT_EQ(t.size(), 2u) << "a = " << a << ", h = " << h;
      EXPECT_NEAR((t[1] - t[0]) / (2 * std::sqrt(2 * h / curvature)), 1, 0.03);
      for (const double root : t) EXPECT_LE(distance_to_torus(a, ray, root), 4e-15);
    }
}

// An exact tangent may count or not, but what is returned is on the surface, and asking on comes to an end.
TEST(TorusLimits, ExactTangentsEnd) {
  Random random(4);
  for (const double ratio : {1e-3, 0.25, 0.75, 1.0, 1.5})
    for (int i = 0; i < 20000; ++i) {
      const Torus torus = torus_of(ratio);
      const double a = ratio_of(torus);
      const SurfacePoint point = torus.at({random.uniform(), i % 3 ? random.uniform() : 0.25 * (i % 4)});
      DoubleRay ray{point.p, random.tangent(point.n)};
      ray.o -= 3 * (1 + a) * ray.d;
      const auto t = crossings(torus, ray);
      EXPECT_LE(t.size(), 6u);
      for (const double root : t) EXPECT_LE(distance_to_torus(a, ray, root), 4e-15 * (1 + a));
    }
}

// A ray that leaves the surface never hits where it starts; one that enters crosses the tube first: a ball of
// radius a around a point of the ring touches the surface from within, so the chord is at least 2a cos θ.
TEST(TorusLimits, StartsOnTheSurfaceDoNotHitThemselves) {
  Random random(5);
  for (const double ratio : {1e-3, 0.25, 0.75, 1.0})
    for (int i = 0; i < 50000; ++i) {
      const Torus torus = torus_of(ratio);
      const double a = ratio_of(torus);
      const SurfacePoint point = torus.at(random.square());
      const Vec3d d = random.direction();
      const double cosine = dot(d, point.n);
      if (std::abs(cosine) < 0.01 || glm::length(point.dpdu) < 0.01) continue;
      const auto t = torus.intersect(point.p, d, 0, unbounded);
      if (cosine < 0) {
        ASSERT_TRUE(t);
        EXPECT_GE(*t, -2 * a * cosine * (1 - 1e-9));
      } else if (t) {
        EXPECT_GT(*t, 1e-6 * a);
      }
    }
}

TEST(TorusLimits, RaysFromWithinCrossAnOddNumberOfTimes) {
  Random random(6);
  for (const double ratio : {1e-3, 0.25, 0.75, 1.0, 1.5, 4.0})
    for (int i = 0; i < 20000; ++i) {
      const Torus torus = torus_of(ratio);
      const double a = ratio_of(torus);
      const double phi = random.uniform(0, 2 * pi_d), depth = a * random.uniform(0, 0.999),
                   psi = random.uniform(0, 7);
      const double rho = 1 + depth * std::cos(psi);
      const DoubleRay ray{{rho * std::cos(phi), rho * std::sin(phi), depth * std::sin(psi)},
                          random.direction()};
      // Where a spindle's tube reaches over the axis, p is within the inner sheet as well: 0 or 2 sheets to
      // leave.
      const bool also_inner = std::hypot(std::abs(rho) + 1, ray.o.z) < a;
      const auto t = crossings(torus, ray);
      EXPECT_EQ(t.size() % 2, also_inner ? 0u : 1u);
      for (const double root : t) EXPECT_LE(distance_to_torus(a, ray, root), 4e-15 * (1 + a));
    }
}

// Close to the axis ρ has a kink. A plane through it cuts the surface in two circles, which a line in that
// plane meets twice each or not at all; a spindle's circles go on beyond the axis, as its inner sheet.
TEST(TorusLimits, LinesThroughTheAxis) {
  Random random(7);
  for (const double ratio : {1e-3, 0.25, 0.75, 0.99, 1.5, 4.0})
    for (int i = 0; i < 20000; ++i) {
      const double a = ratio_of(torus_of(ratio)), height = random.uniform(-1, 1) * 1.2 * a;
      const double elevation = random.uniform(-1, 1) * 1.2 * a;
      const Vec3d d = glm::normalize(Vec3d(1, 0, elevation));
      std::size_t expected = 0;
      bool grazes = std::abs(sqr(height) + 1 - a * a) < 1e-9;  // where a spindle's sheets meet
      for (const double middle : {-1.0, 1.0}) {
        const double off = std::abs(height + middle * elevation) / std::hypot(1.0, elevation);
        grazes = grazes || std::abs(off - a) < 1e-12;
        expected += off < a ? 2 : 0;
      }
      const double tiny = i % 2 ? random.power_of_ten(-300, -16) : 0;
      const DoubleRay ray{Vec3d(0, tiny, height) - 4.0 * (1 + a) * d, d};
      if (!grazes) {
        EXPECT_EQ(crossings(torus_of(ratio), ray).size(), expected) << tiny;
      }
    }
}

// In the plane of the ring, tangent to its inner side: the line touches once and crosses twice.
TEST(TorusLimits, TangentsOfTheInnerEquatorCrossAnEvenNumberOfTimes) {
  Random random(8);
  for (const double ratio : {1e-3, 0.25, 0.75, 1.5})
    for (int i = 0; i < 20000; ++i) {
      const double a = ratio_of(torus_of(ratio)), phi = random.uniform(0, 2 * pi_d), half = 2 * std::sqrt(a);
      const Vec3d inwards(std::cos(phi), std::sin(phi), 0), d(-std::sin(phi), std::cos(phi), 0);
      const auto t = crossings(torus_of(ratio), {std::abs(1 - a) * inwards - 5.0 * d, d});
      ASSERT_EQ(t.size() % 2, 0u);
      ASSERT_GE(t.size(), 2u);
      EXPECT_NEAR(t.front(), 5 - half, 1e-13);
      EXPECT_NEAR(t.back(), 5 + half, 1e-13);
    }
}

// Just below the top circle ρ = 1, z = a the surface is the ring |ρ − 1| < q, q² = a² − z², of nearly no
// depth. A line in that plane, at the distance 1 − ε from the axis with ε > q, passes it twice.
TEST(TorusLimits, ShallowChordsBelowTheTopCircleAreFound) {
  Random random(9);
  for (const double ratio : {1e-3, 0.25, 0.75, 1.5})
    for (int i = 0; i < 20000; ++i) {
      const double a = ratio_of(torus_of(ratio)), z = a * (1 - random.power_of_ten(-11, -6));
      const double q = std::sqrt((a - z) * (a + z));
      const double y = 1 - q * random.power_of_ten(0.2, 2), phi = random.uniform(0, 2 * pi_d);
      const double near = std::sqrt((1 - q - y) * (1 - q + y)), far = std::sqrt((1 + q - y) * (1 + q + y));
      const Vec3d d(-std::sin(phi), std::cos(phi), 0);
      const auto t = crossings(torus_of(ratio), {Vec3d(y * d.y, -y * d.x, z) - 5.0 * d, d});
      ASSERT_EQ(t.size(), 4u) << "a = " << a << ", a - z = " << a - z << ", y = " << y;
      const double expected[] = {-far, -near, near, far};
      for (std::size_t k = 0; k < 4; ++k) {
        // By so much a change of 1e-15 (1 + a) in the distance from the surface moves the crossing.
        const double bound = 1e-15 * (1 + a) * a / (q * std::abs(expected[k]));
        EXPECT_NEAR(t[k] - 5, expected[k], bound + 1e-15);
        EXPECT_LE(distance_to_torus(a, {Vec3d(y * d.y, -y * d.x, z) - 5.0 * d, d}, t[k]), 2e-15 * (1 + a));
      }
    }
}

}  // namespace
}  // namespace umbral::test
