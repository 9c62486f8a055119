// Evaluation and sampling of panes: a visible normal, then Fresnel's choice between back and through.
#include "bsdf/layers/pane.h"

#include "bsdf/facets/microfacet_albedo.h"

namespace umbral {
namespace {

// The share of the lost light that comes back; of each channel, and to draw by.
Spectrum share_back(const Pane& pane) {
  return pane.skin.average_albedo() / (1 - ggx_average_loss(pane.skin.ggx));
}

Spectrum facet_reflectance(const Pane& pane, const Vec3& o, const Vec3& i) {
  return pane.skin.interface.reflectance(std::min(1.0f, 0.5f * glm::length(o + i)));
}

// Both are turned to the side z ≥ 0; `through` tells whether they were on two.
struct Turned {
  Vec3 o, i;
  bool through;
};
Turned turned(const Vec3& wo, const Vec3& wi) {
  return {on_side_of(wo, wo), on_side_of(wi, wi), !same_side(wo, wi)};
}

}  // namespace

Spectrum Pane::f_cos(const Vec3& wo, const Vec3& wi) const {
  if (only_delta() || wo.z == 0 || wi.z == 0) return black;
  const auto [o, i, through] = turned(wo, wi);
  const Ggx& ggx = skin.ggx;
  const Spectrum back = glm::min(white, share_back(*this));
  const float mean = std::max(1e-9f, ggx_average_loss(ggx));
  Spectrum f =
      (through ? white - back : back) * (ggx_loss(ggx, o) * ggx_loss(ggx, i) * inverse_pi / mean * i.z);
  const Vec3 sum = o + i;
  const float length = glm::length(sum);
  if (length > 1e-12f) {
    const Spectrum share = facet_reflectance(*this, o, i);
    f += (through ? white - share : share) * (ggx.density(sum / length) * ggx.shadowed_cos(o, i));
  }
  return through ? f * transmittance : f;
}

float Pane::pdf(const Vec3& wo, const Vec3& wi) const {
  if (only_delta() || wo.z == 0 || wi.z == 0) return 0;
  const auto [o, i, through] = turned(wo, wi);
  const float lost = ggx_loss(skin.ggx, o);
  const float back = std::min(1.0f, luminance(share_back(*this)));
  const float share = std::min(1.0f, luminance(facet_reflectance(*this, o, i)));
  return lost * (through ? 1 - back : back) * lossy_direction_pdf(i.z, skin.round_alpha()) +
         (1 - lost) * (through ? 1 - share : share) * skin.pdf(o, i);
}

std::optional<BsdfSample> Pane::sample(const Vec3& wo, float u1, const Vec2& u2) const {
  const Vec3 o = on_side_of(wo, wo);
  if (only_delta()) {
    const Spectrum share = skin.interface.reflectance(o.z);
    const float chance = std::min(1.0f, luminance(share));
    if (u1 < chance) return BsdfSample{{-wo.x, -wo.y, wo.z}, share / chance, 0, true};
    return BsdfSample{-wo, transmittance * (white - share) / (1 - chance), 0, true};
  }
  if (wo.z == 0) return std::nullopt;
  const auto to_side = [&](const Vec3& wi, bool through) {
    return sample_at(*this, wo, on_side_of(wi, through ? -wo : wo));
  };
  const float lost = ggx_loss(skin.ggx, o);
  if (u1 < lost) {
    const bool through = u1 >= lost * std::min(1.0f, luminance(share_back(*this)));
    return to_side(sample_lossy_direction(u2, skin.round_alpha()), through);
  }
  const std::optional<Vec3> wi = skin.sample(o, u2);
  if (!wi) return std::nullopt;
  const float share = std::min(1.0f, luminance(facet_reflectance(*this, o, *wi)));
  return to_side(*wi, (u1 - lost) / (1 - lost) >= share);
}

}  // namespace umbral
