// Rays against tori: closed-form cases, and a slow reference in long double for all others.
#include <gtest/gtest.h>

#include "scene/shapes/rays.h"

namespace umbral::test {
namespace {

std::optional<double> first(double a, const DoubleRay& ray) {
  return torus_of(a).intersect(ray.o, ray.d, 0, unbounded);
}

void expect_crossings(double a, const DoubleRay& ray, const std::vector<double>& expected) {
  const std::vector<double> found = crossings(torus_of(a), ray);
  ASSERT_EQ(found.size(), expected.size());
  for (std::size_t i = 0; i < found.size(); ++i) EXPECT_NEAR(found[i], expected[i], 4e-15 * (1 + a)) << i;
}

TEST(TorusCrossing, AlongTheAxisThroughTheHoleMisses) {
  Random random(1);
  for (int i = 0; i < 1000; ++i) {
    const double rho = i == 0 ? 0 : random.uniform(0, 0.75), phi = random.uniform(0, 7);
    EXPECT_FALSE(first(0.25, {{rho * std::cos(phi), rho * std::sin(phi), -3}, {0, 0, 1}}));
    EXPECT_FALSE(first(0.25, {{1.2500001, 0, -3}, {0, 0, 1}}));
  }
}

TEST(TorusCrossing, ParallelToTheAxis) {
  Random random(2);
  for (const double a : {0.25, 0.75, 1.0})
    for (int i = 0; i < 1000; ++i) {
      const double rho = 1 + 0.999 * a * random.uniform(-1, 1), phi = random.uniform(0, 7);
      const Vec3d o(rho * std::cos(phi), rho * std::sin(phi), -3);
      const double half = std::sqrt((a - (rho - 1)) * (a + (rho - 1)));
      const auto t = crossings(torus_of(a), {o, {0, 0, 1}});
      ASSERT_EQ(t.size(), 2u);
      EXPECT_NEAR((t[0] - 3) * half, -half * half, 4e-15);
      EXPECT_NEAR((t[1] - 3) * half, half * half, 4e-15);
    }
}

TEST(TorusCrossing, InThePlaneOfTheRing) {
  expect_crossings(0.25, {{-3, 0, 0}, {1, 0, 0}}, {1.75, 2.25, 3.75, 4.25});
  expect_crossings(0.25, {{0, 5, 0}, {0, -1, 0}}, {3.75, 4.25, 5.75, 6.25});
  const double y = 0.5, outer = std::sqrt(1.25 * 1.25 - y * y), inner = std::sqrt(0.75 * 0.75 - y * y);
  expect_crossings(0.25, {{-3, y, 0}, {1, 0, 0}}, {3 - outer, 3 - inner, 3 + inner, 3 + outer});
  const double beyond = std::sqrt(1.25 * 1.25 - 1);
  expect_crossings(0.25, {{-3, 1, 0}, {1, 0, 0}}, {3 - beyond, 3 + beyond});
  expect_crossings(0.25, {{-3, 1.26, 0}, {1, 0, 0}}, {});
}

TEST(TorusCrossing, InAPlaneAboveTheRing) {
  const double z = 0.15, half = std::sqrt(0.25 * 0.25 - z * z);  // 0.2
  expect_crossings(0.25, {{-3, 0, z}, {1, 0, 0}}, {2 - half, 2 + half, 4 - half, 4 + half});
  expect_crossings(0.25, {{-3, 0, 0.26}, {1, 0, 0}}, {});
}

TEST(TorusCrossing, MeridianPlane) {
  // Through the middles of both tubes' circles, at 45°: x = z + 1.
  const double half = 0.25;
  const DoubleRay ray{{1 - 3 * std::sqrt(0.5), 0, -3 * std::sqrt(0.5)}, {std::sqrt(0.5), 0, std::sqrt(0.5)}};
  expect_crossings(0.25, ray, {3 - half, 3 + half});
}

TEST(TorusCrossing, SpindleHasAnInnerSheet) {
  expect_crossings(1.5, {{-4, 0, 0}, {1, 0, 0}}, {1.5, 3.5, 4.5, 6.5});
  expect_crossings(1.5, {{0, 0, 0}, {0, 1, 0}}, {0.5, 2.5});
  const double pole = std::sqrt(1.25);
  EXPECT_NEAR(*first(1.5, {{0, 0, 0}, {0, 0, -1}}), pole, 4e-15);
  EXPECT_NEAR(*first(1.5, {{0, 0, -3}, {0, 0, 1}}), 3 - pole, 4e-15);
}

TEST(TorusCrossing, IntervalIsOpen) {
  const Torus torus = torus_of(0.25);
  const Vec3d o(-3, 0, 0), d(1, 0, 0);
  EXPECT_EQ(torus.intersect(o, d, 0, 1.75), std::nullopt);
  EXPECT_EQ(torus.intersect(o, d, 1.75, 2.25), std::nullopt);
  EXPECT_EQ(torus.intersect(o, d, 1.75, 2.2500001), 2.25);
  EXPECT_EQ(torus.intersect(o, d, 2, unbounded), 2.25);
  EXPECT_EQ(torus.intersect(o, d, 2.3, 3.7), std::nullopt);
  EXPECT_EQ(torus.intersect(o, d, 4.25, unbounded), std::nullopt);
  EXPECT_EQ(torus.intersect(o, d, 100, unbounded), std::nullopt);
}

TEST(TorusCrossing, LengthOfTheDirectionScalesTheDistanceBitForBit) {
  Random random(3);
  for (const double a : {1e-3, 0.25, 1.5})
    for (int i = 0; i < 3000; ++i) {
      const DoubleRay ray = random.isotropic_line(1 + a);
      const auto t = first(a, ray);
      for (const int k : {-400, -60, 1, 60, 400}) {
        const auto scaled = first(a, {ray.o, ray.d * std::ldexp(1, k)});
        ASSERT_EQ(scaled.has_value(), t.has_value());
        EXPECT_EQ(std::ldexp(scaled.value_or(0), k), t.value_or(0));
      }
    }
}

TEST(TorusCrossing, NothingIsHitByAnInvalidRay) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for (const double a : {0.25, 1.5}) {
    EXPECT_FALSE(first(a, {{-3, 0, 0}, {0, 0, 0}}));
    EXPECT_FALSE(first(a, {{nan, 0, 0}, {1, 0, 0}}));
    EXPECT_FALSE(first(a, {{-3, 0, 0}, {1, nan, 0}}));
    EXPECT_FALSE(first(a, {{-unbounded, 0, 0}, {1, 0, 0}}));
  }
}

// The crossings of one sheet, ρ around `center`. The distance to it changes no faster than t: an interval at
// whose ends it is of one sign, and together more than the interval's length, holds none. Others are halved
// until they are too short to hold more than one turn.
class ReferenceSheet {
 public:
  ReferenceSheet(double a, double center, const DoubleRay& ray) : a_(a), center_(center), ray_(ray) {}

  // Appends the crossings between `from` and `to`; false if the ray grazes, so that rounding decides.
  bool collect(long double from, long double to, std::vector<double>& found) const {
    return collect({from, distance(from)}, {to, distance(to)}, found);
  }

 private:
  struct Place {
    long double t, d;
  };

  bool collect(const Place& low, const Place& high, std::vector<double>& found) const {
    const bool passes = low.d * high.d < 0;
    const long double length = high.t - low.t;
    if (!passes && std::abs(low.d + high.d) > length) return true;
    if (length > 2e-5L) {
      const long double t = (low.t + high.t) / 2;
      const Place middle{t, distance(t)};
      return collect(low, middle, found) && collect(middle, high, found);
    }
    if (passes) {
      found.push_back(root(low.t, high.t));
      return true;
    }
    const long double side = low.d > 0 ? 1 : -1;
    const long double turn = lowest(low.t, high.t, side), value = side * distance(turn);
    if (std::abs(value) < 1e-13L) return false;
    if (value > 0) return true;
    found.push_back(root(low.t, turn));
    found.push_back(root(turn, high.t));
    return true;
  }

  long double distance(long double t) const {
    const long double x = ray_.o.x + t * ray_.d.x, y = ray_.o.y + t * ray_.d.y, z = ray_.o.z + t * ray_.d.z;
    const long double from_circle = std::sqrt(x * x + y * y) - center_;
    return std::sqrt(from_circle * from_circle + z * z) - a_;
  }

  double root(long double low, long double high) const {
    const bool rises = distance(low) < 0;
    for (int i = 0; i < 80; ++i) {
      const long double middle = (low + high) / 2;
      ((distance(middle) < 0) == rises ? low : high) = middle;
    }
    return static_cast<double>(low);
  }

  long double lowest(long double low, long double high, long double side) const {
    for (int i = 0; i < 50; ++i) {
      const long double b = low + (high - low) * 0.4L, c = low + (high - low) * 0.6L;
      if (side * distance(b) < side * distance(c))
        high = c;
      else
        low = b;
    }
    return (low + high) / 2;
  }

  double a_, center_;
  DoubleRay ray_;
};

// An isotropic line, one close to the axis, one close to a tangent, or one that starts within the bounds.
DoubleRay ray_of_kind(int kind, double a, Random& random) {
  DoubleRay ray = random.isotropic_line(1 + a);
  if (kind == 1) {
    const double off = random.power_of_ten(-14, 0);
    ray.o = Vec3d(off, 0, random.uniform(-1, 1) * (1 + a)) - 3 * (1 + a) * ray.d;
  } else if (kind == 2) {
    const SurfacePoint point = torus_of(a).at(random.square());
    const double off = a * random.power_of_ten(-11, 0) * (random.uniform() < 0.5 ? -1 : 1);
    ray.d = random.tangent(point.n);
    ray.o = point.p + off * point.n - 3 * (1 + a) * ray.d;
  } else if (kind == 3) {
    ray.o += (1 + a) * random.uniform(0.5, 2.5) * ray.d;
  }
  return ray;
}

TEST(TorusCrossing, AgreesWithTheReference) {
  Random random(4);
  int skipped = 0, crossed = 0, total = 0;
  for (const double ratio : {1e-3, 0.05, 0.25, 0.75, 0.99, 1.0, 1.01, 1.5, 4.0}) {
    const double a = ratio_of(torus_of(ratio));
    for (int i = 0; i < 1000; ++i, ++total) {
      const DoubleRay ray = ray_of_kind(i % 4, a, random);
      std::vector<double> expected;
      const bool clear = ReferenceSheet(a, 1, ray).collect(0, 6 * (1 + a), expected) &&
                         ReferenceSheet(a, -1, ray).collect(0, 6 * (1 + a), expected);
      if (!clear) {
        ++skipped;
        continue;
      }
      std::sort(expected.begin(), expected.end());
      const std::vector<double> found = crossings(torus_of(ratio), ray);
      ASSERT_EQ(found.size(), expected.size()) << "a = " << a << ", ray " << i;
      for (std::size_t k = 0; k < found.size(); ++k) {
        EXPECT_NEAR(found[k], expected[k], 1e-7 * (1 + a));  // where it grazes; the next line is sharp
        EXPECT_LE(distance_to_torus(a, ray, found[k]), 4e-15 * (1 + a));
      }
      crossed += found.empty() ? 0 : 1;
    }
  }
  EXPECT_LT(skipped, total / 50);
  EXPECT_GT(crossed, total / 2);
}

}  // namespace
}  // namespace umbral::test
