// Gauss-Legendre quadrature, plain and adaptive, in double.
#pragma once

#include <array>
#include <cmath>

#include "core/math.h"

namespace umbral::test {

/// Nodes and weights on [0, 1] of the rule with N points, found by Newton's method on the Legendre polynomial.
template <int N>
struct GaussLegendre {
  std::array<double, N> x{}, w{};

  GaussLegendre() {
    for (int i = 0; i < N; ++i) {
      double z = std::cos(pi_d * (i + 0.75) / (N + 0.5)), slope = 1;
      for (int step = 0; step < 20; ++step) {
        double p = 1, before = 0;
        for (int k = 1; k <= N; ++k) {
          const double next = ((2 * k - 1) * z * p - (k - 1) * before) / k;
          before = p;
          p = next;
        }
        slope = N * (z * p - before) / (z * z - 1);
        z -= p / slope;
      }
      x[i] = (1 - z) / 2;
      w[i] = 1 / ((1 - z * z) * slope * slope);
    }
  }
};

/// ∫ f(x) dx over [low, high].
template <int N = 32, class F>
double integral(double low, double high, F&& f) {
  static const GaussLegendre<N> rule;
  double sum = 0;
  for (int i = 0; i < N; ++i) sum += rule.w[i] * f(low + (high - low) * rule.x[i]);
  return sum * (high - low);
}

struct Box2d {
  double x0, x1, y0, y1;
};

/// ∫∫ f(x, y) dx dy over the box.
template <int N = 8, class F>
double integral(const Box2d& box, F&& f) {
  return integral<N>(box.x0, box.x1, [&](double x) {
    return integral<N>(box.y0, box.y1, [&](double y) { return f(x, y); });
  });
}

/// The same, halved in both axes until that changes nothing beyond `tolerance` (absolute), `depth` times at most.
template <int N = 8, class F>
double adaptive_integral(const Box2d& box, F&& f, double tolerance, int depth = 10) {
  const double whole = integral<N>(box, f);
  const double x = (box.x0 + box.x1) / 2, y = (box.y0 + box.y1) / 2;
  const Box2d quarters[] = {
      {box.x0, x, box.y0, y}, {x, box.x1, box.y0, y}, {box.x0, x, y, box.y1}, {x, box.x1, y, box.y1}};
  double sum = 0;
  for (const Box2d& quarter : quarters) sum += integral<N>(quarter, f);
  if (depth == 0 || std::abs(sum - whole) <= tolerance) return sum;
  sum = 0;
  for (const Box2d& quarter : quarters) sum += adaptive_integral<N>(quarter, f, tolerance / 2, depth - 1);
  return sum;
}

}  // namespace umbral::test
