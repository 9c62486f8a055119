// Evaluation and sampling of cloth: the fuzz evenly over the hemisphere, the body by the cosine.
#include "bsdf/lobes/sheen.h"

#include "bsdf/layers/fuzz.h"
#include "bsdf/layers/skin.h"
#include "core/warp.h"

namespace umbral {
namespace {

Fuzz fuzz_of(const Sheen& lobe) { return Fuzz::of_roughness(lobe.sheen_roughness); }

// The part of f |cos θi| beneath the fuzz, for directions with z ≥ 0.
Spectrum body_of(const Sheen& lobe, const Fuzz& fuzz, const Vec3& o, const Vec3& i) {
  const Spectrum& color = lobe.sheen_color;
  return body_f_cos(lobe.reflectance, color * fuzz.albedo(o.z), color * fuzz.albedo(i.z),
                    color * fuzz.average_albedo(), i.z);
}

}  // namespace

Spectrum Sheen::f_cos(const Vec3& wo, const Vec3& wi) const {
  if (!same_side(wo, wi)) return black;
  const Vec3 o = on_side_of(wo, wo), i = on_side_of(wi, wi);
  const Fuzz fuzz = fuzz_of(*this);
  return sheen_color * fuzz.f_cos(o, i) + body_of(*this, fuzz, o, i);
}

void Sheen::each_part(const Vec3& wo, const Vec3& wi, PartVisit visit) const {
  if (!same_side(wo, wi)) return;
  const Vec3 o = on_side_of(wo, wo), i = on_side_of(wi, wi);
  const Fuzz fuzz = fuzz_of(*this);
  visit(sheen_color * fuzz.f_cos(o, i), Spread::matte(fuzz.lean()));
  visit(body_of(*this, fuzz, o, i), Spread::matte(fuzz.lean_of_passed(luminance(sheen_color))));
}

float Sheen::pdf(const Vec3& wo, const Vec3& wi) const {
  if (!same_side(wo, wi)) return 0;
  const float chance = skin_probability(sheen_color * fuzz_of(*this).albedo(std::abs(wo.z)), reflectance);
  return chance * Fuzz::sample_pdf() + (1 - chance) * cosine_hemisphere_pdf(std::abs(wi.z));
}

std::optional<BsdfSample> Sheen::sample(const Vec3& wo, float u1, const Vec2& u2) const {
  const float chance = skin_probability(sheen_color * fuzz_of(*this).albedo(std::abs(wo.z)), reflectance);
  const Vec3 wi = u1 < chance ? Fuzz::sample(u2) : square_to_cosine_hemisphere(u2);
  return sample_at(*this, wo, on_side_of(wi, wo));
}

Spectrum Sheen::albedo() const {
  const Spectrum fuzz = sheen_color * fuzz_of(*this).albedo(1);
  return fuzz + reflectance * (white - fuzz);
}

// Fuzz has no highlight: what it reflects on average is diffuse to a local model.
BlinnPhongCoefficients Sheen::local_model() const {
  const Spectrum fuzz = sheen_color * fuzz_of(*this).average_albedo();
  const Spectrum diffuse = fuzz + reflectance * (white - fuzz);
  return {diffuse, diffuse, black, 1};
}

}  // namespace umbral
