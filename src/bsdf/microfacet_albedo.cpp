// Surfaces of mirrors, without stretch and with: tables of what single bounces lose.
#include "bsdf/microfacet_albedo.h"

#include "bsdf/albedo_quadrature.h"

namespace umbral {
namespace {

template <int flat, int round>
float mirror_loss(const Ggx& ggx, const Vec3& wo) {
  return static_cast<float>(mean_over_normals<flat, round>(ggx, wo, [&](const Vec3& h) {
    const Vec3 wi = reflected(wo, h);
    return wi.z > 0 ? 1.0 - bounce_weight(ggx, wo, wi) : 1.0;
  }));
}

// 1 − E of the surface without stretch, over √alpha and the angle coordinate.
class MirrorTable {
 public:
  MirrorTable() {
    for (int r = 0; r < rough; ++r) {
      const float alpha = alpha_of_row(r, rough);
      for (int s = 0; s < angles; ++s) {
        const float cos_theta = std::max(cos_of_coordinate(node(s, angles), alpha), smallest_cos);
        loss_[r][s] = mirror_loss<40, 32>({alpha, alpha}, direction(cos_theta, 0));
      }
    }
    for (int r = 0; r < rough; ++r)
      average_[r] = fourth_root(hemisphere_average([&](float c) { return loss(c, alpha_of_row(r, rough)); }));
  }

  float loss(float cos_theta, float alpha) const {
    const Cell r = row_of_alpha(alpha, rough), s = cell_of(angle_coordinate(cos_theta, alpha), angles);
    const auto along = [&](const auto& row) { return glm::mix(row[s.i], row[s.i + 1], s.t); };
    return glm::mix(along(loss_[r.i]), along(loss_[r.i + 1]), r.t);
  }

  float average_loss(float alpha) const {
    const Cell r = row_of_alpha(alpha, rough);
    return fourth_power(glm::mix(average_[r.i], average_[r.i + 1], r.t));
  }

 private:
  static constexpr int rough = 48, angles = 48;
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
        const float c = std::max(cos_of_coordinate(node(s, angles), alpha_of_row(r, rough)), smallest_cos);
        Harmonics values{};
        for (int i = 0; i < terms; ++i)
          values[i] = mirror_loss<20, 16>(ggx, direction(c, static_cast<float>(i) * pi / (2 * (terms - 1))));
        loss_[r][s] = transformed(values);
      }
    }
    // The mean over the azimuth is the first term alone.
    for (int r = 0; r < rough; ++r)
      average_[r] =
          fourth_root(hemisphere_average([&](float c) { return loss(c, 0, alpha_of_row(r, rough), 1); }));
  }

  // Summed up to `count` terms.
  float loss(float cos_theta, float cos_2phi, float alpha, int count = terms) const {
    const Cell r = row_of_alpha(alpha, rough), s = cell_of(angle_coordinate(cos_theta, alpha), angles);
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
    const Cell r = row_of_alpha(alpha, rough);
    return fourth_power(glm::mix(average_[r.i], average_[r.i + 1], r.t));
  }

 private:
  static constexpr int rough = 32, angles = 32, terms = 7;
  using Harmonics = std::array<float, terms>;

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

template <class Get>
float interpolated_stretch(const Ggx& ggx, Get&& get) {
  static Tables<StretchedTable, 21> tables;
  const float alpha = (ggx.alpha_x + ggx.alpha_y) / 2;
  const float stretch = std::abs(ggx.alpha_x - ggx.alpha_y) / (2 * alpha);
  return tables.interpolated(
      stretch, [&](const StretchedTable& table) { return get(table, alpha); },
      [](float a, float b, float t) { return glm::mix(a, b, t); }, [](float x) { return StretchedTable(x); });
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

Vec3 sample_lossy_direction(const Vec2& u, float alpha) {
  const float cos2 = std::min(1.0f, sqr(alpha) * std::expm1(u.x * std::log1p(1 / sqr(alpha))));
  const float sine = std::sqrt(1 - cos2), phi = two_pi * u.y;
  return {sine * std::cos(phi), sine * std::sin(phi), std::sqrt(cos2)};
}

float lossy_direction_pdf(float cos_theta, float alpha) {
  return cos_theta * inverse_pi / ((sqr(cos_theta) + sqr(alpha)) * std::log1p(1 / sqr(alpha)));
}

}  // namespace umbral
