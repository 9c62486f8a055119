// Microfacet surfaces with the GGX distribution of slopes: densities, shadowing and sampling of half-vectors.
#pragma once

#include <algorithm>
#include <optional>

#include "core/math.h"

namespace umbral {

// `w` mirrored at the facet with normal h.
inline Vec3 reflected(const Vec3& w, const Vec3& h) { return 2 * dot(w, h) * h - w; }

// The GGX distribution [Walter et al. 2007], stretched along x and y, with the height-correlated masking and shadowing
// of Smith [Heitz 2014]. All directions are local, unit, with z ≥ 0. Nothing subtracts nearly equal numbers, so
// every function keeps its digits for any alpha and towards the horizon.
struct Ggx {
  // Below this width (0.06°) the surface is a mirror: towards the horizon its highlight gets as narrow as the steps
  // between the directions that floats can hold.
  static constexpr float smallest_alpha = 1e-3f;

  float alpha_x, alpha_y;  // root of twice the variance of the slope along x and y

  // alpha = roughness², stretched to alpha (1 ± anisotropy) [Kulla and Conty 2017]; anisotropy in (−1, 1).
  static Ggx of_roughness(float roughness, float anisotropy = 0) {
    const float alpha = sqr(roughness);
    return {std::max(alpha * (1 + anisotropy), smallest_alpha),
            std::max(alpha * (1 - anisotropy), smallest_alpha)};
  }

  bool is_round() const { return alpha_x == alpha_y; }
  // The width of round facets whose density is as high along the normal.
  float round_alpha() const { return is_round() ? alpha_x : std::sqrt(alpha_x * alpha_y); }

  // Area of facets with normal h per area of surface and solid angle: D(h).
  float density(const Vec3& h) const {
    const float q = sqr(h.x / alpha_x) + sqr(h.y / alpha_y) + sqr(h.z);
    return 1 / (pi * alpha_x * alpha_y * q * q);
  }

  // S(w) = cos θ (1 + 2 Λ(w)): the root that all of Smith's terms are made of, at least cos θ.
  float spread(const Vec3& w) const { return std::sqrt(sqr(w.z) + sqr(alpha_x * w.x) + sqr(alpha_y * w.y)); }

  // G₂(wo, wi)/(4 cos θo): with D and F this is f |cos θi| on one side of the surface.
  float shadowed_cos(const Vec3& wo, const Vec3& wi) const {
    const float sum = wo.z * spread(wi) + wi.z * spread(wo);
    return sum > 0 ? 0.5f * (wi.z / sum) : 0.0f;
  }

  // Density of sample_visible_normal(), per solid angle of h: G₁(wo) max(0, wo·h) D(h)/cos θo.
  float visible_normal_pdf(const Vec3& wo, const Vec3& h) const {
    const float facing = dot(wo, h);
    return facing > 0 ? 2 * facing * density(h) / (wo.z + spread(wo)) : 0.0f;
  }

  // Density of the directions that mirror wo at these normals, per solid angle.
  float mirrored_pdf(const Vec3& wo, const Vec3& wi) const { return density_of_mirrored(wo, wi, wo.z); }

  // Density of sample_reflection(), per solid angle of wi with wi.z > 0.
  float reflection_pdf(const Vec3& wo, const Vec3& wi) const {
    return density_of_mirrored(wo, wi, reflecting_cap(wo) * wo.z);
  }

  // A normal visible from wo, by a spherical cap in the space where the surface is a sphere
  // [Dupuy and Benyoub 2023]. h.z = 0 where the draw has no normal (the two ends of the cap cancel).
  Vec3 sample_visible_normal(const Vec3& wo, const Vec2& u) const { return normal_of_cap(wo, 1, u); }

  // A direction that mirrors wo at a facet; none where it would enter the surface, which the bound on the cap of normals
  // makes rare [Eto and Tokuyoshi 2023].
  std::optional<Vec3> sample_reflection(const Vec3& wo, const Vec2& u) const {
    const Vec3 wi = reflected(wo, normal_of_cap(wo, reflecting_cap(wo), u));
    if (!(wi.z > 0)) return std::nullopt;
    return wi;
  }

  // The exponent of Blinn and Phong whose highlight is as wide [Walter et al. 2007].
  float exponent() const { return glm::clamp(2 / (alpha_x * alpha_y) - 2, 0.0f, 1e6f); }

 private:
  // The part of the cap's height below the horizon that mirrors wo upwards, or more; in [0, 1).
  float reflecting_cap(const Vec3& wo) const {
    const float alpha2 = sqr(std::min({alpha_x, alpha_y, 1.0f}));
    const float s2 = sqr(1 + std::sqrt(sqr(wo.x) + sqr(wo.y)));
    return (1 - alpha2) * s2 / (s2 + alpha2 * sqr(wo.z));
  }

  // `below` = the height of the cap below the horizon times spread(wo).
  float density_of_mirrored(const Vec3& wo, const Vec3& wi, float below) const {
    const Vec3 sum = wo + wi;
    const float length2 = dot(sum, sum);
    if (!(length2 > 1e-24f)) return 0;
    return density(sum / std::sqrt(length2)) / (2 * (below + spread(wo)));
  }

  // The normal of a point of the cap that reaches `share` of its whole height below the horizon.
  Vec3 normal_of_cap(const Vec3& wo, float share, const Vec2& u) const {
    const Vec3 stretched = glm::normalize(Vec3{alpha_x * wo.x, alpha_y * wo.y, wo.z});
    const float below = share * stretched.z;
    const float z = (1 - u.y) * (1 + below) - below;
    const float r = safe_sqrt((1 - z) * (1 + z));
    const float phi = two_pi * u.x;
    const Vec3 sum = Vec3{r * std::cos(phi), r * std::sin(phi), z} + stretched;
    if (!(sum.z > 0)) return {1, 0, 0};
    return glm::normalize(Vec3{alpha_x * sum.x, alpha_y * sum.y, sum.z});
  }
};

// `w` in the frame that is turned by the angle (degrees, counter-clockwise) about z. Rounded in one way, whatever a compiler
// makes of sums of products: what refracts at nearly alike media sees the last digit of both directions.
inline Vec3 turned(const Vec3& w, float degrees) {
  const float angle = degrees * (pi / 180), c = std::cos(angle), s = std::sin(angle);
  return {std::fma(c, w.x, s * w.y), std::fma(c, w.y, -s * w.x), w.z};
}

// `w` refracted at the facet with normal h, on the side of which it is; eta = index beyond / index before. None at total
// internal reflection.
inline std::optional<Vec3> refracted_at(const Vec3& w, const Vec3& h, float eta) {
  const float cos_i = dot(w, h);
  const float sin2_t = std::max(0.0f, 1 - sqr(cos_i)) / sqr(eta);
  if (sin2_t >= 1) return std::nullopt;
  return glm::normalize((cos_i / eta - std::sqrt(1 - sin2_t)) * h - w / eta);
}

}  // namespace umbral
