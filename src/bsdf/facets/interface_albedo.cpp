// Rough interfaces between dielectrics, without stretch: tables of what single bounces reflect and lose.
#include "bsdf/facets/albedo_quadrature.h"
#include "bsdf/facets/microfacet_albedo.h"

namespace umbral {
namespace {

// One bounce at an interface from its outer (eta > 1) or inner (eta < 1) side; eta = beyond over before.
InterfaceShares interface_bounce(float cos_theta, float alpha, float eta) {
  const Ggx ggx{alpha, alpha};
  const Vec3 wo = direction(cos_theta, 0);
  const glm::dvec2 shares =
      mean_over_normals<48, 32>(ggx, wo, [&](const Vec3& h) { return interface_bounce_at(ggx, wo, h, eta); });
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
        const float alpha = alpha_of_row(r, rough);
        const float c = std::max(cos_of_coordinate(node(s, angles), alpha), smallest_cos);
        const InterfaceShares outside = interface_bounce(c, alpha, eta);
        shares_[r][s] = {outside.reflected - fresnel_dielectric(c, eta), outside.lost,
                         interface_bounce(c, alpha, 1 / eta).lost};
      }
    for (int r = 0; r < rough; ++r) {
      const auto average = [&](float Values::*part) {
        return hemisphere_average([&](float c) { return shares(c, alpha_of_row(r, rough)).*part; });
      };
      averages_[r] = {average(&Values::reflected), fourth_root(average(&Values::lost_outside)),
                      fourth_root(average(&Values::lost_inside))};
    }
  }

  Values shares(float cos_theta, float alpha) const {
    const Cell r = row_of_alpha(alpha, rough), s = cell_of(angle_coordinate(cos_theta, alpha), angles);
    const auto along = [&](const auto& row) { return mix(row[s.i], row[s.i + 1], s.t); };
    Values values = mix(along(shares_[r.i]), along(shares_[r.i + 1]), r.t);
    values.reflected = glm::clamp(values.reflected + fresnel_dielectric(cos_theta, eta_), 0.0f, 1.0f);
    return values;
  }

  Values averages(float alpha) const {
    const Cell r = row_of_alpha(alpha, rough);
    const Values roots = mix(averages_[r.i], averages_[r.i + 1], r.t);
    return {roots.reflected, fourth_power(roots.lost_outside), fourth_power(roots.lost_inside)};
  }

  static Values mix(const Values& a, const Values& b, float t) {
    return {glm::mix(a.reflected, b.reflected, t), glm::mix(a.lost_outside, b.lost_outside, t),
            glm::mix(a.lost_inside, b.lost_inside, t)};
  }

 private:
  static constexpr int rough = 24, angles = 40;
  float eta_;
  std::array<std::array<Values, angles>, rough> shares_;  // `reflected` less that of the smooth interface
  std::array<Values, rough> averages_;                    // roots of the losses
};

Tables<InterfaceTable, index_nodes>& interface_tables() {
  static Tables<InterfaceTable, index_nodes> tables;
  return tables;
}

template <class Get>
InterfaceTable::Values interpolated_index(float eta, Get&& get) {
  return interface_tables().interpolated(coordinate_of_index(eta), get, InterfaceTable::mix,
                                         [](float x) { return InterfaceTable(index_of_coordinate(x)); });
}

}  // namespace

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

}  // namespace umbral
