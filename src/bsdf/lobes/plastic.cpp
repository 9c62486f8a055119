// Evaluation and sampling of plastic: the skin by its visible normals, the body by the cosine.
#include "bsdf/lobes/plastic.h"

#include "bsdf/facets/microfacet_albedo.h"
#include "bsdf/interfaces/fresnel.h"
#include "bsdf/layers/skin.h"
#include "core/warp.h"

namespace umbral {
namespace {

bool is_smooth(const Plastic& lobe) { return sqr(lobe.roughness) < Ggx::smallest_alpha; }

Ggx ggx_of(const Plastic& lobe) { return {sqr(lobe.roughness), sqr(lobe.roughness)}; }

Skin skin_of(const Plastic& lobe) {
  Skin skin{{}, ggx_of(lobe)};
  skin.interface.eta = lobe.eta;
  return skin;
}

// R: what the skin reflects in all.
float skin_albedo(const Plastic& lobe, float cos_theta) {
  if (is_smooth(lobe)) return std::min(1.0f, fresnel_dielectric(cos_theta, lobe.eta));
  return interface_shares(cos_theta, sqr(lobe.roughness), lobe.eta).reflected;
}

float skin_average(const Plastic& lobe) {
  return interface_averages(std::max(sqr(lobe.roughness), Ggx::smallest_alpha), lobe.eta).reflected;
}

// ρ (1 − K)/(1 − ρ K).
Spectrum body_color(const Plastic& lobe, float average) {
  const float leaves = (1 - average) / sqr(lobe.eta);
  return lobe.reflectance * leaves / (1.0f - lobe.reflectance + lobe.reflectance * leaves);
}

// The chance to sample the skin, in proportion to what it reflects, but never all of it while there is a body.
float skin_probability(const Plastic& lobe, float skin) {
  const float body = (1 - skin) * luminance(lobe.reflectance);
  return skin + body > 0 ? skin / (skin + body) : 0.5f;
}

// The two parts of f |cos θi|, for directions with z ≥ 0.
Spectrum body_of(const Plastic& lobe, const Vec3& o, const Vec3& i) {
  const float average = skin_average(lobe);
  const float both = (1 - skin_albedo(lobe, o.z)) * (1 - skin_albedo(lobe, i.z));
  return body_color(lobe, average) * (both * inverse_pi / (1 - average) * i.z);
}

Spectrum highlight_of(const Plastic& lobe, const Vec3& o, const Vec3& i) {
  const Vec3 sum = o + i;
  const float length = glm::length(sum);
  if (is_smooth(lobe) || !(length > 1e-12f)) return black;
  const Ggx ggx = ggx_of(lobe);
  return fresnel_dielectric(0.5f * length, lobe.eta) * ggx.density(sum / length) * ggx.shadowed_cos(o, i) *
         white;
}

}  // namespace

Spectrum Plastic::f_cos(const Vec3& wo, const Vec3& wi) const {
  if (!same_side(wo, wi)) return black;
  const Vec3 o = on_side_of(wo, wo), i = on_side_of(wi, wi);
  return body_of(*this, o, i) + highlight_of(*this, o, i);
}

void Plastic::each_part(const Vec3& wo, const Vec3& wi, PartVisit visit) const {
  if (!same_side(wo, wi)) return;
  const Vec3 o = on_side_of(wo, wo), i = on_side_of(wi, wi);
  visit(body_of(*this, o, i), Spread::matte(skin_of(*this).lean_of_passed()));
  visit(highlight_of(*this, o, i), Spread::of_facets(ggx_of(*this).alpha_x));
}

float Plastic::pdf(const Vec3& wo, const Vec3& wi) const {
  if (!same_side(wo, wi)) return 0;
  const Vec3 o = on_side_of(wo, wo), i = on_side_of(wi, wi);
  const float skin = skin_probability(*this, skin_albedo(*this, o.z));
  const float body_pdf = (1 - skin) * cosine_hemisphere_pdf(i.z);
  return is_smooth(*this) ? body_pdf : body_pdf + skin * ggx_of(*this).reflection_pdf(o, i);
}

std::optional<BsdfSample> Plastic::sample(const Vec3& wo, float u1, const Vec2& u2) const {
  const Vec3 o = on_side_of(wo, wo);
  const float reflected_share = skin_albedo(*this, o.z);
  const float skin = skin_probability(*this, reflected_share);
  if (u1 >= skin) return sample_at(*this, wo, on_side_of(square_to_cosine_hemisphere(u2), wo));
  if (is_smooth(*this)) return BsdfSample{{-wo.x, -wo.y, wo.z}, white * (reflected_share / skin), 0, true};
  const auto wi = ggx_of(*this).sample_reflection(o, u2);
  if (!wi) return std::nullopt;
  return sample_at(*this, wo, on_side_of(*wi, wo));
}

float Plastic::internal_reflectance() const { return 1 - (1 - skin_average(*this)) / sqr(eta); }

Spectrum Plastic::albedo() const {
  const float skin = skin_albedo(*this, 1);
  return white * skin + body_color(*this, skin_average(*this)) * (1 - skin);
}

// The body as seen through the skin along the normal, and the skin's highlight there.
BlinnPhongCoefficients Plastic::local_model() const {
  const float skin = sqr((eta - 1) / (eta + 1));
  const Spectrum body = body_color(*this, skin_average(*this)) * (1 - skin);
  return {body, body, white * skin, is_smooth(*this) ? 1000 : ggx_of(*this).exponent()};
}

}  // namespace umbral
