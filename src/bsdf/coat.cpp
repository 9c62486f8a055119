// Evaluation and sampling of coated metals: the layer by what it reflects, else the metal's own way.
#include "bsdf/coat.h"

#include "bsdf/skin.h"

namespace umbral {
namespace {

Skin skin_of(const Coat& lobe) {
  const float alpha = sqr(lobe.roughness);
  Skin skin{{}, {alpha, alpha}};
  skin.interface.eta = lobe.eta;
  return skin;
}

Conductor metal_of(const Coat& lobe) {
  Conductor metal;
  metal.metal = lobe.metal;
  metal.reflectance = lobe.reflectance;
  metal.roughness = lobe.metal_roughness;
  return metal;
}

float reflected_by_skin(const Coat& lobe, const Vec3& w) { return skin_of(lobe).albedo(std::abs(w.z)).g; }

// The chance to sample the skin.
float skin_chance(const Coat& lobe, const Vec3& wo) {
  const Spectrum below = metal_of(lobe).fresnel(std::abs(wo.z)) * lobe.transmittance * lobe.transmittance;
  return skin_probability(grey(reflected_by_skin(lobe, wo)), below);
}

Spectrum passed(const Coat& lobe, const Vec3& wo, const Vec3& wi) {
  const float skin = std::max(reflected_by_skin(lobe, wo), reflected_by_skin(lobe, wi));
  return lobe.transmittance * lobe.transmittance * (1 - skin);
}

}  // namespace

bool Coat::only_delta() const { return skin_of(*this).is_smooth() && metal_of(*this).only_delta(); }

Spectrum Coat::f_cos(const Vec3& wo, const Vec3& wi) const {
  if (!same_side(wo, wi)) return black;
  return passed(*this, wo, wi) * metal_of(*this).f_cos(wo, wi) +
         skin_of(*this).f_cos(on_side_of(wo, wo), on_side_of(wi, wi));
}

float Coat::pdf(const Vec3& wo, const Vec3& wi) const {
  if (!same_side(wo, wi)) return 0;
  const float chance = skin_chance(*this, wo);
  return chance * skin_of(*this).pdf(on_side_of(wo, wo), on_side_of(wi, wi)) +
         (1 - chance) * metal_of(*this).pdf(wo, wi);
}

std::optional<BsdfSample> Coat::sample(const Vec3& wo, float u1, const Vec2& u2) const {
  const float chance = skin_chance(*this, wo);
  if (u1 < chance) {
    const Skin skin = skin_of(*this);
    if (skin.is_smooth())
      return BsdfSample{{-wo.x, -wo.y, wo.z}, white * (reflected_by_skin(*this, wo) / chance), 0, true};
    const std::optional<Vec3> wi = skin.sample(on_side_of(wo, wo), u2);
    return wi ? sample_at(*this, wo, on_side_of(*wi, wo)) : std::nullopt;
  }
  const float u = std::min((u1 - chance) / (1 - chance), one_minus_epsilon);
  std::optional<BsdfSample> drawn = metal_of(*this).sample(wo, u, u2);
  if (!drawn) return std::nullopt;
  if (!drawn->delta) return sample_at(*this, wo, drawn->wi);
  drawn->weight *= passed(*this, wo, drawn->wi) / (1 - chance);
  return drawn;
}

Spectrum Coat::albedo() const {
  const Vec3 normal{0, 0, 1};
  return grey(reflected_by_skin(*this, normal)) + passed(*this, normal, normal) * metal_of(*this).fresnel(1);
}

// One highlight for both, as wide as the sharper.
BlinnPhongCoefficients Coat::local_model() const {
  BlinnPhongCoefficients k = metal_of(*this).local_model();
  const float skin = skin_of(*this).interface.f0();
  k.ks = glm::min(white, skin * white + (1 - skin) * transmittance * transmittance * k.ks);
  const Ggx ggx = skin_of(*this).ggx;
  k.exponent = std::max(k.exponent, skin_of(*this).is_smooth() ? 1000.0f : ggx.exponent());
  return k;
}

}  // namespace umbral
