// Surfaces of mirrors, without stretch: tables of what single bounces lose.
#include "bsdf/facets/microfacet_albedo.h"

#include "bsdf/facets/albedo_quadrature.h"
#include "bsdf/facets/stretched_albedo.h"

namespace umbral {
namespace {

// 1 − E of the surface without stretch, over √alpha and the angle coordinate.
class MirrorTable {
 public:
  MirrorTable() {
    for (int r = 0; r < rough; ++r) {
      const float alpha = alpha_of_row(r, rough);
      for (int s = 0; s < angles; ++s) {
        const float cos_theta = std::max(cos_of_coordinate(node(s, angles), alpha), smallest_cos);
        const Ggx ggx{alpha, alpha};
        const Vec3 wo = direction(cos_theta, 0);
        loss_[r][s] = static_cast<float>(
            mean_over_normals<40, 32>(ggx, wo, [&](const Vec3& h) { return mirror_loss_at(ggx, wo, h); }));
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

}  // namespace

float ggx_loss(const Ggx& ggx, const Vec3& w) {
  return ggx.is_round() ? mirror_table().loss(w.z, ggx.alpha_x) : stretched_mirror_loss(ggx, w);
}

float ggx_average_loss(const Ggx& ggx) {
  return ggx.is_round() ? mirror_table().average_loss(ggx.alpha_x) : stretched_mirror_average_loss(ggx);
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
