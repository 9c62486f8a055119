// Evaluation and sampling: the skin by its visible normals, the body by the cosine.
#include "bsdf/layers/gloss.h"

#include "core/warp.h"

namespace umbral {

namespace {

// The matte part of f |cos θi|, for directions with z ≥ 0.
Spectrum body_of(const Gloss& lobe, const Vec3& o, const Vec3& i) {
  const Skin& skin = lobe.skin;
  return body_f_cos(lobe.reflectance, skin.albedo(o), skin.albedo(i), skin.average_albedo(), i.z);
}

}  // namespace

Spectrum Gloss::f_cos(const Vec3& wo, const Vec3& wi) const {
  if (!same_side(wo, wi)) return black;
  const Vec3 o = on_side_of(wo, wo), i = on_side_of(wi, wi);
  return body_of(*this, o, i) + skin.f_cos(o, i);
}

void Gloss::each_part(const Vec3& wo, const Vec3& wi, PartVisit visit) const {
  if (!same_side(wo, wi)) return;
  const Vec3 o = on_side_of(wo, wo), i = on_side_of(wi, wi);
  visit(body_of(*this, o, i), Spread::matte(skin.lean_of_passed()));
  visit(skin.f_cos(o, i), Spread::of_facets(skin.round_alpha()));
}

float Gloss::pdf(const Vec3& wo, const Vec3& wi) const {
  if (!same_side(wo, wi)) return 0;
  const Vec3 o = on_side_of(wo, wo), i = on_side_of(wi, wi);
  const float chance = skin_probability(skin.albedo(o), reflectance);
  return (1 - chance) * cosine_hemisphere_pdf(i.z) + chance * skin.pdf(o, i);
}

std::optional<BsdfSample> Gloss::sample(const Vec3& wo, float u1, const Vec2& u2) const {
  const Vec3 o = on_side_of(wo, wo);
  const Spectrum reflected_share = skin.albedo(o);
  const float chance = skin_probability(reflected_share, reflectance);
  if (u1 >= chance) return sample_at(*this, wo, on_side_of(square_to_cosine_hemisphere(u2), wo));
  if (skin.is_smooth()) return BsdfSample{{-wo.x, -wo.y, wo.z}, reflected_share / chance, 0, true};
  const std::optional<Vec3> wi = skin.sample(o, u2);
  if (!wi) return std::nullopt;
  return sample_at(*this, wo, on_side_of(*wi, wo));
}

Spectrum Gloss::albedo(float cos_theta) const {
  const Spectrum share = skin.albedo(cos_theta);
  return share + reflectance * (white - share);
}

}  // namespace umbral
