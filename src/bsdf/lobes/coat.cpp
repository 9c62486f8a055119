// Evaluation and sampling of coats: the layer by what it reflects, else as the lobe beneath draws.
#include "bsdf/lobes/coat.h"

#include "bsdf/layers/cover.h"
#include "bsdf/lobes.h"

namespace umbral {
namespace {

Skin skin_of(const Coat& lobe) {
  const float alpha = sqr(lobe.roughness);
  Skin skin{{}, {alpha, alpha}};
  skin.interface.eta = lobe.eta;
  return skin;
}

Cover cover_of(const Coat& lobe) {
  return {skin_of(lobe), 1, lobe.transmittance, glm::min(white, albedo(*lobe.base))};
}

// The chance to sample the skin. What is dark along the normal may shine at grazing angles: it is always drawn too.
float skin_chance(const Coat& lobe, const Cover& cover, float reflected) {
  const Spectrum below = glm::max(cover.albedo_beneath, grey(0.1f)) * lobe.transmittance * lobe.transmittance;
  return skin_probability(grey(reflected), below);
}

// visit(f |cos θi|, spread) of each part beneath the skin.
template <class Visit>
void visit_parts(const Coat& lobe, const Vec3& wo, const Vec3& wi, Visit&& visit) {
  if (!same_side(wo, wi)) return;
  const Cover cover = cover_of(lobe);
  const Passage passage(cover, wo.z, wi.z);
  umbral::each_part(*lobe.base, wo, wi, [&](const Spectrum& part, Spread spread) {
    if (!is_black(part)) visit(part * passage.of(spread), spread);
  });
}

// What the skin itself reflects.
Spectrum highlight_of(const Skin& skin, const Vec3& wo, const Vec3& wi) {
  if (skin.is_smooth() || !same_side(wo, wi)) return black;
  return skin.f_cos(on_side_of(wo, wo), on_side_of(wi, wi));
}

}  // namespace

bool Coat::only_delta() const { return skin_of(*this).is_smooth() && umbral::only_delta(*base); }

Spectrum Coat::f_cos(const Vec3& wo, const Vec3& wi) const {
  Spectrum f = highlight_of(skin_of(*this), wo, wi);
  visit_parts(*this, wo, wi, [&](const Spectrum& part, Spread) { f += part; });
  return f;
}

void Coat::each_part(const Vec3& wo, const Vec3& wi, PartVisit visit) const {
  const Skin skin = skin_of(*this);
  if (!skin.is_smooth()) visit(highlight_of(skin, wo, wi), Spread::of_facets(skin.ggx.alpha_x));
  visit_parts(*this, wo, wi,
              [&](const Spectrum& part, Spread spread) { visit(part, spread.under(skin.lean_of_passed())); });
}

float Coat::pdf(const Vec3& wo, const Vec3& wi) const {
  if (!same_side(wo, wi)) return 0;
  const Cover cover = cover_of(*this);
  const float chance = skin_chance(*this, cover, Passage(cover, wo.z, wo.z).reflected());
  return chance * cover.skin.pdf(on_side_of(wo, wo), on_side_of(wi, wi)) +
         (1 - chance) * umbral::pdf(*base, wo, wi);
}

std::optional<BsdfSample> Coat::sample(const Vec3& wo, float u1, const Vec2& u2) const {
  const Cover cover = cover_of(*this);
  const Passage passage(cover, wo.z, wo.z);
  const float chance = skin_chance(*this, cover, passage.reflected());
  if (u1 < chance) {
    if (cover.skin.is_smooth())
      return BsdfSample{{-wo.x, -wo.y, wo.z}, white * (passage.reflected() / chance), 0, true};
    const std::optional<Vec3> wi = cover.skin.sample(on_side_of(wo, wo), u2);
    return wi ? sample_at(*this, wo, on_side_of(*wi, wo)) : std::nullopt;
  }
  const float u = std::min((u1 - chance) / (1 - chance), one_minus_epsilon);
  std::optional<BsdfSample> drawn = umbral::sample(*base, wo, u, u2);
  if (!drawn || !same_side(wo, drawn->wi)) return std::nullopt;
  if (!drawn->delta) return sample_at(*this, wo, drawn->wi);
  drawn->weight *= passage.of_mirror() / (1 - chance);
  return drawn;
}

Spectrum Coat::albedo() const {
  const Cover cover = cover_of(*this);
  const Passage passage(cover, 1, 1);
  return glm::min(white, grey(passage.reflected()) + passage.of_mirror() * cover.albedo_beneath);
}

// One highlight for both, as wide as the sharper.
BlinnPhongCoefficients Coat::local_model() const {
  BlinnPhongCoefficients k = to_blinn_phong(*base);
  const Skin skin = skin_of(*this);
  const float reflected = skin.interface.f0();
  const Spectrum passed = (1 - reflected) * transmittance * transmittance;
  const float exponent = skin.is_smooth() ? 1000.0f : skin.ggx.exponent();
  k.exponent = is_black(k.ks) ? exponent : std::max(k.exponent, exponent);
  k.ka *= passed;
  k.kd *= passed;
  k.ks = glm::min(white, reflected * white + passed * k.ks);
  return k;
}

}  // namespace umbral
