// Tables of scales: the operator of the facets on a grid of cosines, and the scaling that each layer asks for.
#include "bsdf/layers/layer_scale.h"

#include <vector>

#include "bsdf/facets/albedo_quadrature.h"
#include "bsdf/facets/microfacet_albedo.h"
#include "bsdf/interfaces/fresnel.h"

namespace umbral {
namespace {

// A function of the cosine by its values where the root of the cosine is even: T goes with the cosine at the horizon.
constexpr int angles = 32;
struct Row {
  explicit Row(double value) { at.fill(value); }
  Row& operator+=(const Row& other) {
    for (int i = 0; i < angles; ++i) at[i] += other.at[i];
    return *this;
  }
  Row operator*(double factor) const {
    Row result = *this;
    for (double& x : result.at) x *= factor;
    return result;
  }
  Row operator/(double divisor) const { return *this * (1 / divisor); }

  std::array<double, angles> at;
};

float cosine_of(int i) { return std::max(sqr(node(i, angles)), smallest_cos); }

// What the value at a cosine is made of, by linear interpolation.
Row weights_at(float cos_theta) {
  const Cell cell = cell_of(std::sqrt(cos_theta), angles);
  Row row(0);
  row.at[cell.i] = 1 - cell.t;
  row.at[cell.i + 1] = cell.t;
  return row;
}

double dot(const Row& a, const Row& b) {
  double sum = 0;
  for (int i = 0; i < angles; ++i) sum += a.at[i] * b.at[i];
  return sum;
}

// Where the light goes that single bounces lose: by loss times cosine.
Row lost_directions(float alpha) {
  Row sum(0);
  double total = 0;
  constexpr int steps = 512;
  for (int i = 0; i < steps; ++i) {
    const float x = (static_cast<float>(i) + 0.5f) / steps;
    const double weight = ggx_loss({alpha, alpha}, {0, 0, x * x}) * x * x * x;
    sum += weights_at(x * x) * weight;
    total += weight;
  }
  return sum / total;
}

// B: to which cosines light from each cosine goes, as Conductor scatters it; its rows sum to 1.
class Facets {
 public:
  explicit Facets(float alpha) {
    const Ggx ggx{alpha, alpha};
    const Row lost = lost_directions(alpha);
    for (int i = 0; i < angles; ++i) {
      const Vec3 wo = direction(cosine_of(i), 0);
      Row row = mean_over_normals<24, 16>(ggx, wo, [&](const Vec3& h) {
        const Vec3 wi = reflected(wo, h);
        return wi.z > 0 ? weights_at(wi.z) * bounce_weight(ggx, wo, wi) : Row(0);
      });
      row += lost * std::max(0.0, 1 - dot(row, Row(1)));
      rows_.push_back(row / dot(row, Row(1)));
    }
  }

  // d with d (B d) = T; each step takes the geometric mean of d and T/(B d).
  Row scaling(const Row& passed) const {
    Row d(1);
    for (int step = 0; step < 20; ++step) {
      Row next(0);
      for (int i = 0; i < angles; ++i) next.at[i] = std::sqrt(d.at[i] * passed.at[i] / dot(rows_[i], d));
      d = next;
    }
    return d;
  }

 private:
  std::vector<Row> rows_;
};

constexpr int widths = 24;  // even in the root of alpha

const Facets& facets_of_row(int row) {
  static Tables<Facets, widths> tables;
  return tables.at(row, [](float x) { return Facets(std::max(sqr(x), Ggx::smallest_alpha)); });
}

// g over a row of layers, of which passed(x, cos θ) lets pass T, the width of the facets and the cosine.
template <int layers>
class ScaleGrid {
 public:
  template <class Passed>
  explicit ScaleGrid(const Passed& passed_by) {
    for (int l = 0; l < layers; ++l) {
      Row passed(0);
      for (int i = 0; i < angles; ++i)
        passed.at[i] = std::max(1e-12, static_cast<double>(passed_by(node(l, layers), cosine_of(i))));
      for (int w = 0; w < widths; ++w) {
        const Row d = facets_of_row(w).scaling(passed);
        for (int i = 0; i < angles; ++i)
          scale_[l][w][i] = static_cast<float>(d.at[i] / std::sqrt(passed.at[i]));
      }
    }
  }

  float at(float layer, float alpha, float cos_theta) const {
    const Cell l = cell_of(layer, layers), w = cell_of(std::sqrt(alpha), widths),
               c = cell_of(std::sqrt(cos_theta), angles);
    const auto along = [&](const auto& row) { return glm::mix(row[c.i], row[c.i + 1], c.t); };
    const auto of_layer = [&](const auto& rows) {
      return glm::mix(along(rows[w.i]), along(rows[w.i + 1]), w.t);
    };
    return glm::mix(of_layer(scale_[l.i]), of_layer(scale_[l.i + 1]), l.t);
  }

 private:
  std::array<std::array<std::array<float, angles>, widths>, layers> scale_;
};

float mix(float a, float b, float t) { return glm::mix(a, b, t); }

float passed_by_skin(float cos_theta, float alpha, float eta) {
  if (alpha < Ggx::smallest_alpha) return 1 - fresnel_dielectric(cos_theta, eta);
  return 1 - interface_shares(cos_theta, alpha, eta).reflected;
}

// Skins by their roughness, fuzz by where its own lies between the least and 1.
using SkinScales = ScaleGrid<24>;
using FuzzScales = ScaleGrid<12>;
constexpr float least_roughness = 0.1f;  // root of Fuzz::smallest_alpha
float fuzz_roughness(float x) { return least_roughness + (1 - least_roughness) * x; }

}  // namespace

float skin_scale(float cos_theta, float alpha, float skin_alpha, float eta) {
  static Tables<SkinScales, index_nodes> tables;
  return tables.interpolated(
      coordinate_of_index(eta),
      [&](const SkinScales& grid) { return grid.at(std::sqrt(skin_alpha), alpha, cos_theta); }, mix,
      [](float x) {
        return SkinScales([eta = index_of_coordinate(x)](float roughness, float c) {
          return passed_by_skin(c, sqr(roughness), eta);
        });
      });
}

float fuzz_scale(float cos_theta, float alpha, const Fuzz& fuzz, float strength) {
  static Tables<FuzzScales, 5> tables;
  const float layer = (std::sqrt(fuzz.alpha) - least_roughness) / (1 - least_roughness);
  return tables.interpolated(
      strength, [&](const FuzzScales& grid) { return grid.at(layer, alpha, cos_theta); }, mix,
      [](float strength_of_table) {
        return FuzzScales([=](float x, float c) {
          return 1 - strength_of_table * Fuzz::of_roughness(fuzz_roughness(x)).albedo(c);
        });
      });
}

}  // namespace umbral
