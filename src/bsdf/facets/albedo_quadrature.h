// What the tables of rough surfaces' albedos share: their coordinates, single bounces, and quadrature over facets and hemispheres.
#pragma once

#include <array>
#include <atomic>
#include <memory>
#include <mutex>

#include "bsdf/facets/microfacet.h"
#include "bsdf/facets/table_cell.h"
#include "bsdf/interfaces/fresnel.h"

namespace umbral {

// Rows of tables are at even steps of the root of alpha.
inline float alpha_of_row(int row, int rows) { return std::max(sqr(node(row, rows)), Ggx::smallest_alpha); }
inline Cell row_of_alpha(float alpha, int rows) { return cell_of(std::sqrt(alpha), rows); }

// E changes with angle on the scale cos θ ≈ alpha, however small alpha is, and steeply towards the horizon: in these
// coordinates it is about as smooth everywhere.
inline float angle_coordinate(float cos_theta, float alpha) {
  return std::sqrt(cos_theta * (1 + alpha) / (cos_theta + alpha));
}
inline float cos_of_coordinate(float x, float alpha) { return x * x * alpha / (1 + alpha - x * x); }

inline Vec3 direction(float cos_theta, float phi) {
  const float sine = safe_sqrt((1 - cos_theta) * (1 + cos_theta));
  return {sine * std::cos(phi), sine * std::sin(phi), cos_theta};
}

// The weight G₂/G₁ of a direction drawn by a visible normal.
inline float bounce_weight(const Ggx& ggx, const Vec3& wo, const Vec3& wi) {
  const float zi = std::abs(wi.z), zo = wo.z;
  return zi * (zo + ggx.spread(wo)) / (zo * ggx.spread(wi) + zi * ggx.spread(wo));
}

// What a mirror with the normal h loses of light from wo.
inline double mirror_loss_at(const Ggx& ggx, const Vec3& wo, const Vec3& h) {
  const Vec3 wi = reflected(wo, h);
  return wi.z > 0 ? 1.0 - bounce_weight(ggx, wo, wi) : 1.0;
}

// What a facet of an interface reflects to the side of wo, and what it loses; eta = beyond over before.
inline glm::dvec2 interface_bounce_at(const Ggx& ggx, const Vec3& wo, const Vec3& h, float eta) {
  const float f = fresnel_dielectric(dot(wo, h), eta);
  const Vec3 back = reflected(wo, h);
  const double kept = back.z > 0 ? f * bounce_weight(ggx, wo, back) : 0;
  double lost = f - kept;
  if (f < 1) {
    const std::optional<Vec3> through = refracted_at(wo, h, eta);
    lost += (1.0 - f) * (through && through->z < 0 ? 1.0 - bounce_weight(ggx, wo, *through) : 1.0);
  }
  return {kept, lost};
}

inline constexpr float smallest_cos = 1e-6f;  // E is continuous at the horizon

// Mean of f(visible normal) over its distribution: midpoints, of which those of u.y crowd where normals are flat, as
// light gets lost there.
template <int flat, int round, class F>
auto mean_over_normals(const Ggx& ggx, const Vec3& wo, F&& f) {
  decltype(f(wo)) sum(0);
  double weights = 0;
  for (int j = 0; j < flat; ++j) {
    const float v = (static_cast<float>(j) + 0.5f) / flat;
    const double weight = sqr(1 - v);
    decltype(f(wo)) ring(0);
    for (int i = 0; i < round; ++i)
      ring += f(
          ggx.sample_visible_normal(wo, {(static_cast<float>(i) + 0.5f) / round, 1 - sqr(1 - v) * (1 - v)}));
    sum += ring * weight;
    weights += round * weight;
  }
  return sum / weights;
}

// The same by a Fibonacci lattice [Sloan and Joe 1994] of `points`, a number of Fibonacci's, and the number before it; with a
// third of the points it is as exact as even steps, where stretched facets ask for many directions.
template <int points, int before, class F>
double lattice_mean_over_normals(const Ggx& ggx, const Vec3& wo, F&& f) {
  double sum = 0, weights = 0;
  for (int i = 0; i < points; ++i) {
    const float u = static_cast<float>(i * before % points) / points;
    const float v = (static_cast<float>(i) + 0.5f) / points;
    sum += (1 - v) * f(ggx.sample_visible_normal(wo, {u, 1 - sqr(1 - v)}));
    weights += 1 - v;
  }
  return sum / weights;
}

// 2 ∫ f(cos θ) cos θ d cos θ by Simpson's rule over x, cos θ = x².
template <class F>
float hemisphere_average(F&& f) {
  constexpr int steps = 256;
  double sum = 0;
  for (int i = 1; i <= steps; ++i) {
    const float x = static_cast<float>(i) / steps;
    sum += (i == steps ? 1 : (i % 2 == 1 ? 4 : 2)) * 4.0 * x * x * x * f(x * x);
  }
  return static_cast<float>(sum / (3 * steps));
}

// Mean losses go with a power of the roughness near the fourth: between nodes the root is interpolated.
inline float fourth_root(float x) { return std::sqrt(std::sqrt(std::max(0.0f, x))); }
inline float fourth_power(float x) { return sqr(sqr(x)); }

// The coordinate of an index of refraction, 1 … 10, along which tables for several are kept: √(1 − 1/eta), as the cosine of
// the critical angle is nearly in proportion to it.
inline constexpr int index_nodes = 28;
inline constexpr float widest_index = 0.9f;  // 1 − 1/10
inline float coordinate_of_index(float eta) { return std::sqrt((1 - 1 / eta) / widest_index); }
inline float index_of_coordinate(float x) { return 1 / (1 - widest_index * sqr(x)); }

// Tables that are each made when they are first asked for. Every look-up asks: an atomic pointer answers without the call that
// std::call_once makes each time.
template <class Table, int count>
class MadeWhenAsked {
 public:
  // make() → Table.
  template <class Make>
  const Table& at(int i, Make&& make) {
    const Table* table = ready_[i].load(std::memory_order_acquire);
    if (table) return *table;
    std::call_once(made_[i], [&] {
      tables_[i] = std::make_unique<Table>(make());
      ready_[i].store(tables_[i].get(), std::memory_order_release);
    });
    return *tables_[i];
  }

 private:
  std::array<std::once_flag, count> made_;
  std::array<std::unique_ptr<Table>, count> tables_;
  std::array<std::atomic<const Table*>, count> ready_{};
};

// Such tables at even steps of a coordinate.
template <class Table, int count>
class Tables {
 public:
  // get(Table) → T at x in [0, 1], with mix(T, T, float) between two tables; make(x) → Table.
  template <class Get, class Mix, class Make>
  auto interpolated(float x, Get&& get, Mix&& mix, Make&& make) {
    const Cell cell = cell_of(x, count);
    const auto low = get(at(cell.i, make));
    return cell.t == 0 ? low : mix(low, get(at(cell.i + 1, make)), cell.t);
  }

  template <class Make>
  const Table& at(int i, Make&& make) {
    return tables_.at(i, [&] { return make(node(i, count)); });
  }

 private:
  MadeWhenAsked<Table, count> tables_;
};

}  // namespace umbral
