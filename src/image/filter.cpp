// Inverse cumulative distributions of the filters.
#include "image/filter.h"

namespace umbral {
namespace {

constexpr double cutoff = 3;                           // of the Gaussian, in σ
constexpr float erf_at_cutoff = 0.99730020393673981f;  // erf(3/√2)

constexpr float default_radius(FilterKind kind) {
  switch (kind) {
    case FilterKind::box:
      return 0.5f;
    case FilterKind::tent:
      return 1;
    case FilterKind::gaussian:
      return 1.5f;
  }
  return 0;
}

// erf⁻¹(x) for |x| ≤ 0.9986 within 3 float roundings: the polynomials for single precision of [Giles 2012].
// Samples are drawn for every camera ray; std::erf's inverse does not exist and Boost's takes ten times as
// long.
float erf_inverse(float x) {
  float w = -std::log((1 - x) * (1 + x));
  float p;
  if (w < 5) {
    w -= 2.5f;
    p = 2.81022636e-08f;
    p = 3.43273939e-07f + p * w;
    p = -3.5233877e-06f + p * w;
    p = -4.39150654e-06f + p * w;
    p = 0.00021858087f + p * w;
    p = -0.00125372503f + p * w;
    p = -0.00417768164f + p * w;
    p = 0.246640727f + p * w;
    p = 1.50140941f + p * w;
  } else {
    w = std::sqrt(w) - 3;
    p = -0.000200214257f;
    p = 0.000100950558f + p * w;
    p = 0.00134934322f + p * w;
    p = -0.00367342844f + p * w;
    p = 0.00573950773f + p * w;
    p = -0.0076224613f + p * w;
    p = 0.00943887047f + p * w;
    p = 1.00167406f + p * w;
    p = 2.83297682f + p * w;
  }
  return p * x;
}

float sample_tent(float u) { return u < 0.5f ? std::sqrt(2 * u) - 1 : 1 - std::sqrt(2 - 2 * u); }

// In units of the radius, 3σ.
float sample_gaussian(float u) {
  constexpr float sqrt2_over_3 = 0.47140452079103168f;
  const float x = sqrt2_over_3 * erf_inverse((2 * u - 1) * erf_at_cutoff);
  return std::clamp(x, -1.0f, 1.0f);
}

}  // namespace

float Filter::effective_radius() const { return radius > 0 ? radius : default_radius(kind); }

Vec2 Filter::sample(const Vec2& u) const {
  const float r = effective_radius();
  switch (kind) {
    case FilterKind::box:
      return r * (2.0f * u - 1.0f);
    case FilterKind::tent:
      return {r * sample_tent(u.x), r * sample_tent(u.y)};
    case FilterKind::gaussian:
      return {r * sample_gaussian(u.x), r * sample_gaussian(u.y)};
  }
  return {0, 0};
}

double Filter::density(double x) const {
  const double r = effective_radius(), t = std::abs(x) / r;
  if (t > 1) return 0;
  switch (kind) {
    case FilterKind::box:
      return 0.5 / r;
    case FilterKind::tent:
      return (1 - t) / r;
    case FilterKind::gaussian: {
      const double sigmas = cutoff * t;
      return cutoff / r * std::exp(-0.5 * sqr(sigmas)) /
             (std::sqrt(2 * pi_d) * std::erf(cutoff / std::sqrt(2.0)));
    }
  }
  return 0;
}

double Filter::cdf(double x) const {
  const double t = std::clamp(x / effective_radius(), -1.0, 1.0);
  switch (kind) {
    case FilterKind::box:
      return 0.5 + 0.5 * t;
    case FilterKind::tent:
      return t < 0 ? 0.5 * sqr(1 + t) : 1 - 0.5 * sqr(1 - t);
    case FilterKind::gaussian:
      return 0.5 + 0.5 * std::erf(cutoff * t / std::sqrt(2.0)) / std::erf(cutoff / std::sqrt(2.0));
  }
  return 0;
}

}  // namespace umbral
