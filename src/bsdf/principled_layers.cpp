// What the layers of the principled material reflect and let pass.
#include "bsdf/principled_layers.h"

#include "bsdf/layer_scale.h"

namespace umbral {
namespace {

float sheen_strength(const Principled& p) { return max_component(p.sheen_color); }

Fuzz fuzz_of(const Principled& p) { return Fuzz::of_roughness(p.sheen_roughness); }

bool covers(const Principled& p, const Vec3& w) { return w.z > 0 || !p.has_inside(); }

// 1 − s E.
float fuzz_passed(const Principled& p, const Vec3& w) {
  const float strength = sheen_strength(p);
  return strength > 0 ? std::max(0.0f, 1 - strength * fuzz_of(p).albedo(std::abs(w.z))) : 1;
}

}  // namespace

bool PrincipledLayers::scatter(const Principled& p) {
  return (p.clearcoat > 0 && !coat(p).is_smooth()) || sheen_strength(p) > 0;
}

Skin PrincipledLayers::coat(const Principled& p) {
  const float alpha = sqr(p.clearcoat_roughness);
  return {Interface{}, {alpha, alpha}};
}

LayerShares PrincipledLayers::shares(const Principled& p, const Vec3& w) {
  if (!exist(p) || !covers(p, w)) return {};
  return {p.clearcoat > 0 ? p.clearcoat * coat(p).albedo(std::abs(w.z)).g : 0, 1 - fuzz_passed(p, w)};
}

PrincipledLayers::PrincipledLayers(const Principled& p, const Vec3& wo, const Vec3& wi)
    : p_(p),
      cos_o_(std::abs(wo.z)),
      cos_i_(std::abs(wi.z)),
      fuzz_passed_o_(fuzz_passed(p, wo)),
      fuzz_passed_i_(fuzz_passed(p, wi)),
      cover_{coat(p), p.clearcoat},
      covered_o_(covers(p, wo)),
      covered_i_(covers(p, wi)) {
  if (p.clearcoat > 0) passage_.emplace(cover_, wo.z, wi.z);
}

float PrincipledLayers::passed_by_fuzz(Spread spread) const {
  const float strength = sheen_strength(p_);
  if (strength == 0) return 1;
  const Fuzz fuzz = fuzz_of(p_);
  const float both = fuzz_passed_o_ * fuzz_passed_i_;
  if (spread.is_matte())
    return both /
           ((1 - strength * fuzz.average_albedo()) * (1 + spread.lean() * fuzz.lean_of_passed(strength)));
  const auto scale = [&](float cos_theta) { return fuzz_scale(cos_theta, spread.alpha(), fuzz, strength); };
  return std::sqrt(both) * scale(cos_o_) * scale(cos_i_);
}

Spectrum PrincipledLayers::passed(Spread spread) const {
  if (!covered_o_ || !covered_i_) return passed_of_mirror();
  const Spectrum fuzz = white * passed_by_fuzz(spread);
  if (!passage_) return fuzz;
  const float strength = sheen_strength(p_);
  if (!spread.is_matte() || strength == 0) return fuzz * passage_->of(spread);
  return fuzz * passage_->of(Spread::matte(spread.lean() + fuzz_of(p_).lean_of_passed(strength)));
}

Spectrum PrincipledLayers::passed_of_mirror() const {
  if (!covered_o_ && !covered_i_) return white;
  const float fuzz = covered_o_ ? fuzz_passed_o_ : fuzz_passed_i_;
  const float coat = !passage_ ? 1 : passage_->passed_once(covered_o_);
  return white * (fuzz * coat);
}

void PrincipledLayers::each_part(const Vec3& wo, const Vec3& wi, PartVisit visit) const {
  if (!same_side(wo, wi) || !covered_o_) return;
  const Vec3 o = on_side_of(wo, wo), i = on_side_of(wi, wi);
  if (sheen_strength(p_) > 0) {
    const Spectrum fuzz = p_.sheen_color * fuzz_of(p_).f_cos(o, i);
    const Spread spread = Spread::matte(fuzz_of(p_).lean());
    visit(passage_ ? fuzz * passage_->of(spread) : fuzz, spread);
  }
  if (passage_ && !cover_.skin.is_smooth())
    visit(p_.clearcoat * cover_.skin.f_cos(o, i), Spread::of_facets(cover_.skin.ggx.alpha_x));
}

}  // namespace umbral
