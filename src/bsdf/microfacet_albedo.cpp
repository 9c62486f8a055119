// Quadrature of single bounces, and tables of the results.
#include "bsdf/microfacet_albedo.h"

#include <array>
#include <memory>
#include <mutex>

#include "bsdf/fresnel.h"
#include "bsdf/table_cell.h"

namespace umbral {
namespace {

// E changes with angle on the scale cos θ ≈ alpha, however small alpha is, and steeply towards the horizon: in these
// coordinates it is about as smooth everywhere.
float angle_coordinate(float cos_theta, float alpha) {
  return std::sqrt(cos_theta * (1 + alpha) / (cos_theta + alpha));
}
float cos_of_coordinate(float x, float alpha) { return x * x * alpha / (1 + alpha - x * x); }

Vec3 direction(float cos_theta, float phi) {
  const float sine = safe_sqrt((1 - cos_theta) * (1 + cos_theta));
  return {sine * std::cos(phi), sine * std::sin(phi), cos_theta};
}

// The weight G₂/G₁ of a direction drawn by a visible normal.
float bounce_weight(const Ggx& ggx, const Vec3& wo, const Vec3& wi) {
  const float zi = std::abs(wi.z), zo = wo.z;
  return zi * (zo + ggx.spread(wo)) / (zo * ggx.spread(wi) + zi * ggx.spread(wo));
}

constexpr float smallest_cos = 1e-6f;  // E is continuous at the horizon

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

template <int flat, int round>
float mirror_loss(const Ggx& ggx, const Vec3& wo) {
  return static_cast<float>(mean_over_normals<flat, round>(ggx, wo, [&](const Vec3& h) {
    const Vec3 wi = reflected(wo, h);
    return wi.z > 0 ? 1.0 - bounce_weight(ggx, wo, wi) : 1.0;
  }));
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
float fourth_root(float x) { return std::sqrt(std::sqrt(std::max(0.0f, x))); }
float fourth_power(float x) { return sqr(sqr(x)); }

// 1 − E of the surface without stretch, over √alpha and the angle coordinate.
class MirrorTable {
 public:
  MirrorTable() {
    for (int r = 0; r < rough; ++r) {
      const float alpha = alpha_of(r);
      for (int s = 0; s < angles; ++s) {
        const float cos_theta = std::max(cos_of_coordinate(node(s, angles), alpha), smallest_cos);
        loss_[r][s] = mirror_loss<40, 32>({alpha, alpha}, direction(cos_theta, 0));
      }
    }
    for (int r = 0; r < rough; ++r)
      average_[r] = fourth_root(hemisphere_average([&](float c) { return loss(c, alpha_of(r)); }));
  }

  float loss(float cos_theta, float alpha) const {
    const Cell r = cell_of(std::sqrt(alpha), rough), s = cell_of(angle_coordinate(cos_theta, alpha), angles);
    const auto along = [&](const auto& row) { return glm::mix(row[s.i], row[s.i + 1], s.t); };
    return glm::mix(along(loss_[r.i]), along(loss_[r.i + 1]), r.t);
  }

  float average_loss(float alpha) const {
    const Cell r = cell_of(std::sqrt(alpha), rough);
    return fourth_power(glm::mix(average_[r.i], average_[r.i + 1], r.t));
  }

 private:
  static constexpr int rough = 48, angles = 48;
  static float alpha_of(int r) { return std::max(sqr(node(r, rough)), Ggx::smallest_alpha); }

  std::array<std::array<float, angles>, rough> loss_;
  std::array<float, rough> average_;
};

const MirrorTable& mirror_table() {
  static const MirrorTable table;
  return table;
}

// 1 − E of surfaces with one stretch. Over the azimuth it is a sum of cos 2kφ, which its values at five angles settle.
class StretchedTable {
 public:
  explicit StretchedTable(float stretch) {
    for (int r = 0; r < rough; ++r) {
      const Ggx ggx = Ggx::of_roughness(node(r, rough), stretch);
      for (int s = 0; s < angles; ++s) {
        const float c = std::max(cos_of_coordinate(node(s, angles), alpha_of(r)), smallest_cos);
        Harmonics values{};
        for (int i = 0; i < terms; ++i)
          values[i] = mirror_loss<20, 16>(ggx, direction(c, static_cast<float>(i) * pi / (2 * (terms - 1))));
        loss_[r][s] = transformed(values);
      }
    }
    // The mean over the azimuth is the first term alone.
    for (int r = 0; r < rough; ++r)
      average_[r] = fourth_root(hemisphere_average([&](float c) { return loss(c, 0, alpha_of(r), 1); }));
  }

  // Summed up to `count` terms.
  float loss(float cos_theta, float cos_2phi, float alpha, int count = terms) const {
    const Cell r = cell_of(std::sqrt(alpha), rough), s = cell_of(angle_coordinate(cos_theta, alpha), angles);
    const auto along = [&](const auto& row, int k) { return glm::mix(row[s.i][k], row[s.i + 1][k], s.t); };
    float sum = 0, before = cos_2phi, cosine = 1;  // cos (k − 1) 2φ and cos k 2φ
    for (int k = 0; k < count; ++k) {
      sum += cosine * glm::mix(along(loss_[r.i], k), along(loss_[r.i + 1], k), r.t);
      const float next = 2 * cos_2phi * cosine - before;
      before = cosine;
      cosine = next;
    }
    return sum;
  }

  float average_loss(float alpha) const {
    const Cell r = cell_of(std::sqrt(alpha), rough);
    return fourth_power(glm::mix(average_[r.i], average_[r.i + 1], r.t));
  }

 private:
  static constexpr int rough = 32, angles = 32, terms = 7;
  using Harmonics = std::array<float, terms>;

  static float alpha_of(int r) { return std::max(sqr(node(r, rough)), Ggx::smallest_alpha); }

  // Coefficients of cos 2kφ from values at even steps of φ from 0 to 90° (the cosine transform of the first kind).
  static Harmonics transformed(const Harmonics& values) {
    constexpr int last = terms - 1;
    Harmonics result{};
    for (int k = 0; k < terms; ++k) {
      for (int i = 0; i < terms; ++i)
        result[k] +=
            values[i] * std::cos(pi * static_cast<float>(i * k) / last) * (i % last == 0 ? 0.5f : 1.0f);
      result[k] *= (k % last == 0 ? 1.0f : 2.0f) / last;
    }
    return result;
  }

  std::array<std::array<Harmonics, angles>, rough> loss_;
  std::array<float, rough> average_;
};

// Tables at even steps of a coordinate, each made when it is first asked for.
template <class Table, int count>
class Tables {
 public:
  // get(Table) → T at x in [0, 1], with mix(T, T, float) between two tables; make(x) → Table.
  template <class Get, class Mix, class Make>
  auto interpolated(float x, Get&& get, Mix&& mix, Make&& make) {
    const Cell cell = cell_of(x, count);
    const auto low = get(table(cell.i, make));
    return cell.t == 0 ? low : mix(low, get(table(cell.i + 1, make)), cell.t);
  }

 private:
  template <class Make>
  const Table& table(int i, Make&& make) {
    std::call_once(made_[i], [&] { tables_[i] = std::make_unique<Table>(make(node(i, count))); });
    return *tables_[i];
  }

  std::array<std::once_flag, count> made_;
  std::array<std::unique_ptr<Table>, count> tables_;
};

template <class Get>
float interpolated_stretch(const Ggx& ggx, Get&& get) {
  static Tables<StretchedTable, 21> tables;
  const float alpha = (ggx.alpha_x + ggx.alpha_y) / 2;
  const float stretch = std::abs(ggx.alpha_x - ggx.alpha_y) / (2 * alpha);
  return tables.interpolated(
      stretch, [&](const StretchedTable& table) { return get(table, alpha); },
      [](float a, float b, float t) { return glm::mix(a, b, t); }, [](float x) { return StretchedTable(x); });
}

// One bounce at an interface from its outer (eta > 1) or inner (eta < 1) side; eta = beyond over before.
InterfaceShares interface_bounce(float cos_theta, float alpha, float eta) {
  const Ggx ggx{alpha, alpha};
  const Vec3 wo = direction(cos_theta, 0);
  const glm::dvec2 shares = mean_over_normals<48, 32>(ggx, wo, [&](const Vec3& h) {
    const float f = fresnel_dielectric(dot(wo, h), eta);
    const Vec3 back = reflected(wo, h);
    const double kept = back.z > 0 ? f * bounce_weight(ggx, wo, back) : 0;
    double lost = f - kept;
    if (f < 1) {
      const std::optional<Vec3> through = refracted_at(wo, h, eta);
      lost += (1.0 - f) * (through && through->z < 0 ? 1.0 - bounce_weight(ggx, wo, *through) : 1.0);
    }
    return glm::dvec2(kept, lost);
  });
  return {static_cast<float>(shares.x), static_cast<float>(shares.y)};
}

// The tables for one index.
class InterfaceTable {
 public:
  struct Values {
    float reflected, lost_outside, lost_inside;
  };

  explicit InterfaceTable(float eta) : eta_(eta) {
    for (int r = 0; r < rough; ++r)
      for (int s = 0; s < angles; ++s) {
        const float alpha = alpha_of(r);
        const float c = std::max(cos_of_coordinate(node(s, angles), alpha), smallest_cos);
        const InterfaceShares outside = interface_bounce(c, alpha, eta);
        shares_[r][s] = {outside.reflected - fresnel_dielectric(c, eta), outside.lost,
                         interface_bounce(c, alpha, 1 / eta).lost};
      }
    for (int r = 0; r < rough; ++r) {
      const auto average = [&](float Values::*part) {
        return hemisphere_average([&](float c) { return shares(c, alpha_of(r)).*part; });
      };
      averages_[r] = {average(&Values::reflected), fourth_root(average(&Values::lost_outside)),
                      fourth_root(average(&Values::lost_inside))};
    }
  }

  Values shares(float cos_theta, float alpha) const {
    const Cell r = cell_of(std::sqrt(alpha), rough), s = cell_of(angle_coordinate(cos_theta, alpha), angles);
    const auto along = [&](const auto& row) { return mix(row[s.i], row[s.i + 1], s.t); };
    Values values = mix(along(shares_[r.i]), along(shares_[r.i + 1]), r.t);
    values.reflected = glm::clamp(values.reflected + fresnel_dielectric(cos_theta, eta_), 0.0f, 1.0f);
    return values;
  }

  Values averages(float alpha) const {
    const Cell r = cell_of(std::sqrt(alpha), rough);
    const Values roots = mix(averages_[r.i], averages_[r.i + 1], r.t);
    return {roots.reflected, fourth_power(roots.lost_outside), fourth_power(roots.lost_inside)};
  }

  static Values mix(const Values& a, const Values& b, float t) {
    return {glm::mix(a.reflected, b.reflected, t), glm::mix(a.lost_outside, b.lost_outside, t),
            glm::mix(a.lost_inside, b.lost_inside, t)};
  }

 private:
  static constexpr int rough = 24, angles = 40;
  static float alpha_of(int r) { return std::max(sqr(node(r, rough)), Ggx::smallest_alpha); }

  float eta_;
  std::array<std::array<Values, angles>, rough> shares_;  // `reflected` less that of the smooth interface
  std::array<Values, rough> averages_;                    // roots of the losses
};

// Over √(1 − 1/eta): the cosine of the critical angle is nearly in proportion to it.
template <class Get>
InterfaceTable::Values interpolated_index(float eta, Get&& get) {
  static Tables<InterfaceTable, 28> tables;
  constexpr float widest = 0.9f;  // eta = 10
  return tables.interpolated(std::sqrt((1 - 1 / eta) / widest), get, InterfaceTable::mix,
                             [](float x) { return InterfaceTable(1 / (1 - widest * sqr(x))); });
}

}  // namespace

float ggx_loss(const Ggx& ggx, const Vec3& w) {
  if (ggx.alpha_x == ggx.alpha_y) return mirror_table().loss(w.z, ggx.alpha_x);
  const float sine2 = w.x * w.x + w.y * w.y;
  const float along = ggx.alpha_x > ggx.alpha_y ? 1.0f : -1.0f;
  const float cos_2phi = sine2 > 0 ? along * (w.x * w.x - w.y * w.y) / sine2 : 0;
  return interpolated_stretch(ggx, [&](const StretchedTable& table, float alpha) {
    return glm::clamp(table.loss(w.z, cos_2phi, alpha), 0.0f, 1.0f);
  });
}

float ggx_average_loss(const Ggx& ggx) {
  if (ggx.alpha_x == ggx.alpha_y) return mirror_table().average_loss(ggx.alpha_x);
  return interpolated_stretch(
      ggx, [](const StretchedTable& table, float alpha) { return table.average_loss(alpha); });
}

InterfaceShares interface_shares(float cos_theta, float alpha, float eta) {
  const InterfaceTable::Values v = interpolated_index(
      eta, [&](const InterfaceTable& table) { return table.shares(std::abs(cos_theta), alpha); });
  return cos_theta > 0 ? InterfaceShares{v.reflected, v.lost_outside} : InterfaceShares{0, v.lost_inside};
}

InterfaceAverages interface_averages(float alpha, float eta) {
  const InterfaceTable::Values v =
      interpolated_index(eta, [&](const InterfaceTable& table) { return table.averages(alpha); });
  return {v.reflected, v.lost_outside, v.lost_inside};
}

Vec3 sample_lossy_direction(const Vec2& u, float alpha) {
  const float cos2 = std::min(1.0f, sqr(alpha) * std::expm1(u.x * std::log1p(1 / sqr(alpha))));
  const float sine = std::sqrt(1 - cos2), phi = two_pi * u.y;
  return {sine * std::cos(phi), sine * std::sin(phi), std::sqrt(cos2)};
}

float lossy_direction_pdf(float cos_theta, float alpha) {
  return cos_theta * inverse_pi / ((sqr(cos_theta) + sqr(alpha)) * std::log1p(1 / sqr(alpha)));
}

}  // namespace umbral
