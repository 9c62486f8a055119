// Evaluation of fuzz, and the table of what it reflects.
#include "bsdf/layers/fuzz.h"

#include <array>

#include "bsdf/facets/table_cell.h"

namespace umbral {
namespace {

// L(x) of the fit: between its constants for alpha = 0 and 1 it goes by (1 − alpha)².
float fitted_exponent(float x, float alpha) {
  const float t = sqr(1 - alpha);
  const float a = glm::mix(21.5473f, 25.3245f, t), b = glm::mix(3.82987f, 3.32435f, t);
  const float c = glm::mix(0.19823f, 0.16801f, t), d = glm::mix(-1.97760f, -1.27393f, t);
  const float e = glm::mix(-4.32054f, -4.85967f, t);
  return a / (1 + b * std::pow(x, c)) + d * x + e;
}

float lambda(float cos_theta, float alpha) {
  if (cos_theta < 0.5f) return std::exp(fitted_exponent(cos_theta, alpha));
  return std::exp(2 * fitted_exponent(0.5f, alpha) - fitted_exponent(std::max(0.0f, 1 - cos_theta), alpha));
}

constexpr float smallest_cos = 1e-4f;  // 0.006° above the horizon; beneath it f stays as it is there

// f |cos θi| of the fit.
float fitted_f_cos(const Vec3& o, const Vec3& i, float alpha) {
  const Vec3 sum = o + i;
  const float length2 = dot(sum, sum);
  if (!(length2 > 1e-24f) || !(o.z > 0) || !(i.z > 0)) return 0;
  const float sin2 = std::min(1.0f, (sqr(sum.x) + sqr(sum.y)) / length2);
  const float density = (2 + 1 / alpha) * std::pow(sin2, 0.5f / alpha) / two_pi;
  const float zo = std::max(o.z, smallest_cos), zi = std::max(i.z, smallest_cos);
  return density * i.z / ((1 + lambda(zo, alpha) + lambda(zi, alpha)) * 4 * (zo * zi));
}

// ∫ f(o, i) di by midpoints over the hemisphere, whose cosines crowd towards the horizon, where f does.
template <class F>
float quadrature(float cos_theta, F&& f_cos) {
  constexpr int steep = 24, round = 24;
  const Vec3 o{std::sqrt(1 - sqr(cos_theta)), 0, cos_theta};
  double sum = 0;
  for (int s = 0; s < steep; ++s) {
    const float x = (static_cast<float>(s) + 0.5f) / steep, z = x * x * x, sine = std::sqrt(1 - sqr(z));
    for (int r = 0; r < round; ++r) {
      const float phi = pi * (static_cast<float>(r) + 0.5f) / round;
      sum += 3 * sqr(x) * f_cos(o, Vec3{sine * std::cos(phi), sine * std::sin(phi), z});
    }
  }
  return static_cast<float>(sum * 2 * pi / (steep * round));
}

// Over the root of alpha and the cube root of the cosine.
class FuzzTable {
 public:
  FuzzTable() {
    fill(fitted_, [](float alpha, const Vec3& o, const Vec3& i) { return fitted_f_cos(o, i, alpha); });
    fill(albedo_, [&](float alpha, const Vec3& o, const Vec3& i) {
      return fitted_f_cos(o, i, alpha) / excess(o.z, i.z, alpha);
    });
    for (int r = 0; r < rough; ++r) {
      constexpr int steps = 128;
      for (int i = 0; i < steps; ++i) {
        const float x = (static_cast<float>(i) + 0.5f) / steps;
        average_[r] += 4 * x * x * x * albedo(sqr(x), alpha_of(r)) / steps;
      }
    }
  }

  // What f of the fit is divided by.
  float excess(float cos_o, float cos_i, float alpha) const {
    if (alpha > 0.07f) return 1;
    return std::max({1.0f, at(fitted_, cos_o, alpha), at(fitted_, cos_i, alpha)});
  }
  float albedo(float cos_theta, float alpha) const { return at(albedo_, cos_theta, alpha); }
  float average(float alpha) const {
    const Cell r = row_of(alpha);
    return glm::mix(average_[r.i], average_[r.i + 1], r.t);
  }

 private:
  static constexpr int rough = 28, angles = 64;
  static constexpr float lowest = 0.1f;  // root of Fuzz::smallest_alpha
  using Grid = std::array<std::array<float, angles>, rough>;

  static Cell row_of(float alpha) { return cell_of((std::sqrt(alpha) - lowest) / (1 - lowest), rough); }
  static float alpha_of(int r) { return sqr(lowest + (1 - lowest) * node(r, rough)); }

  template <class F>
  static void fill(Grid& grid, F&& f_cos) {
    for (int r = 0; r < rough; ++r)
      for (int s = 0; s < angles; ++s) {
        const float c = std::max(node(s, angles) * sqr(node(s, angles)), smallest_cos);
        grid[r][s] = quadrature(c, [&](const Vec3& o, const Vec3& i) { return f_cos(alpha_of(r), o, i); });
      }
  }

  static float at(const Grid& grid, float cos_theta, float alpha) {
    const Cell r = row_of(alpha), s = cell_of(std::cbrt(cos_theta), angles);
    const auto along = [&](const auto& row) { return glm::mix(row[s.i], row[s.i + 1], s.t); };
    return glm::mix(along(grid[r.i]), along(grid[r.i + 1]), r.t);
  }

  Grid fitted_{}, albedo_{};
  std::array<float, rough> average_{};
};

const FuzzTable& table() {
  static const FuzzTable made;
  return made;
}

}  // namespace

float Fuzz::f_cos(const Vec3& o, const Vec3& i) const {
  return fitted_f_cos(o, i, alpha) / table().excess(o.z, i.z, alpha);
}

float Fuzz::albedo(float cos_theta) const { return table().albedo(cos_theta, alpha); }
float Fuzz::average_albedo() const { return table().average(alpha); }

// The steepness of E is about 0.9 + 0.06/alpha.
float Fuzz::lean() const { return (1 - albedo(1) / average_albedo()) * std::min(2.5f, 0.9f + 0.06f / alpha); }

float Fuzz::lean_of_passed(float strength) const {
  const float average = average_albedo();
  return -lean() * strength * average / (1 - strength * average);
}

}  // namespace umbral
