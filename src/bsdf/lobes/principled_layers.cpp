// What the layers of the principled material reflect and let pass.
#include "bsdf/lobes/principled_layers.h"

#include "bsdf/layers/layer_scale.h"

namespace umbral {
namespace {

float sheen_strength(const Principled& p) { return max_component(p.sheen_color); }

Fuzz fuzz_of(const Principled& p) { return Fuzz::of_roughness(p.sheen_roughness); }

Skin coat_of(const Principled& p) {
  const float alpha = sqr(p.clearcoat_roughness);
  return {Interface{}, {alpha, alpha}};
}

bool coat_leans(const Principled& p) { return p.clearcoat_normal.z != 1; }

bool covers(const Principled& p, const Vec3& w) { return w.z > 0 || !p.has_inside(); }

// c R, as seen under that cosine.
float coat_reflects(const Principled& p, float cos_theta) {
  return p.clearcoat * coat_of(p).albedo(std::abs(cos_theta)).g;
}

// Two directions in the frame of the coat, both above it.
struct OverCoat {
  Vec3 o, i;
};

// None where the coat reflects no light from one to the other.
std::optional<OverCoat> over_coat(const Principled& p, const Vec3& wo, const Vec3& wi) {
  const bool reflected = same_side(wo, wi);
  if (!covers(p, wo)) return std::nullopt;
  if (!coat_leans(p))
    return reflected ? std::optional<OverCoat>({on_side_of(wo, wo), on_side_of(wi, wi)}) : std::nullopt;
  if (!reflected && p.transmits()) return std::nullopt;
  const Frame frame = frame_from_normal(p.clearcoat_normal);
  const Vec3 o = frame.to_local(wo), i = frame.to_local(wi);
  if (!same_side(o, wo) || !same_side(o, i)) return std::nullopt;
  return OverCoat{on_side_of(o, o), on_side_of(i, i)};
}

// 1 − s E.
float fuzz_passed(const Principled& p, const Vec3& w) {
  const float strength = sheen_strength(p);
  return strength > 0 ? std::max(0.0f, 1 - strength * fuzz_of(p).albedo(std::abs(w.z))) : 1;
}

}  // namespace

bool PrincipledLayers::scatter(const Principled& p) {
  return (p.clearcoat > 0 && !coat_is_smooth(p)) || sheen_strength(p) > 0;
}

bool PrincipledLayers::coat_is_smooth(const Principled& p) { return coat_of(p).is_smooth(); }

LayerShares PrincipledLayers::shares(const Principled& p, const Vec3& w) {
  if (!exist(p) || !covers(p, w)) return {};
  const float cosine = coat_leans(p) ? dot(w, p.clearcoat_normal) : w.z;
  const bool reflects = p.clearcoat > 0 && cosine * w.z > 0;
  return {reflects ? coat_reflects(p, cosine) : 0, 1 - fuzz_passed(p, w)};
}

std::optional<Vec3> PrincipledLayers::sample_coat(const Principled& p, const Vec3& wo, const Vec2& u) {
  const Skin skin = coat_of(p);
  const bool leans = coat_leans(p);
  const Frame frame = leans ? frame_from_normal(p.clearcoat_normal) : Frame{};
  const Vec3 o = leans ? frame.to_local(wo) : wo;
  if (skin.is_smooth() && !leans) return Vec3{-wo.x, -wo.y, wo.z};
  const std::optional<Vec3> drawn =
      skin.is_smooth() ? Vec3{-o.x, -o.y, std::abs(o.z)} : skin.sample(on_side_of(o, o), u);
  if (!drawn) return std::nullopt;
  const Vec3 i = on_side_of(*drawn, o);
  if (!leans) return i;
  const Vec3 wi = frame.to_world(i);
  return over_coat(p, wo, wi) ? std::optional(wi) : std::nullopt;
}

float PrincipledLayers::coat_pdf(const Principled& p, const Vec3& wo, const Vec3& wi) {
  const std::optional<OverCoat> over = over_coat(p, wo, wi);
  return over ? coat_of(p).pdf(over->o, over->i) : 0;
}

PrincipledLayers::PrincipledLayers(const Principled& p, const Vec3& wo, const Vec3& wi)
    : p_(p),
      cos_o_(std::abs(wo.z)),
      cos_i_(std::abs(wi.z)),
      fuzz_passed_o_(fuzz_passed(p, wo)),
      fuzz_passed_i_(fuzz_passed(p, wi)),
      cover_{coat_of(p), p.clearcoat},
      covered_o_(covers(p, wo)),
      covered_i_(covers(p, wi)) {
  if (p.clearcoat > 0) passage_.emplace(cover_, wo.z, wi.z);
  if (passage_ && coat_leans(p)) leaning_ = passed_by_leaning(wo, wi);
}

float PrincipledLayers::passed_by_leaning(const Vec3& wo, const Vec3& wi) const {
  const auto ratio = [&](const Vec3& w, bool of_wo) {
    const float passed = 1 - coat_reflects(p_, dot(w, p_.clearcoat_normal));
    return std::max(0.0f, passed) / std::max(1e-6f, passage_->passed_once(of_wo));
  };
  if (!covered_o_ && !covered_i_) return 1;
  return std::min(covered_o_ ? ratio(wo, true) : infinity, covered_i_ ? ratio(wi, false) : infinity);
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
  const Spectrum fuzz = white * (leaning_ * passed_by_fuzz(spread));
  if (!passage_) return fuzz;
  const float strength = sheen_strength(p_);
  if (!spread.is_matte() || strength == 0) return fuzz * passage_->of(spread);
  return fuzz * passage_->of(Spread::matte(spread.lean() + fuzz_of(p_).lean_of_passed(strength)));
}

Spectrum PrincipledLayers::passed_of_mirror() const {
  if (!covered_o_ && !covered_i_) return white;
  const float fuzz = covered_o_ ? fuzz_passed_o_ : fuzz_passed_i_;
  const float coat = !passage_ ? 1 : passage_->passed_once(covered_o_);
  return white * (leaning_ * fuzz * coat);
}

void PrincipledLayers::each_part(const Vec3& wo, const Vec3& wi, PartVisit visit) const {
  if (!covered_o_) return;
  if (sheen_strength(p_) > 0 && same_side(wo, wi)) {
    const float fuzz = leaning_ * fuzz_of(p_).f_cos(on_side_of(wo, wo), on_side_of(wi, wi));
    const Spread spread = Spread::matte(fuzz_of(p_).lean());
    visit(p_.sheen_color * fuzz * (passage_ ? passage_->of(spread) : white), spread);
  }
  if (!passage_ || cover_.skin.is_smooth()) return;
  if (const std::optional<OverCoat> over = over_coat(p_, wo, wi))
    visit(p_.clearcoat * cover_.skin.f_cos(over->o, over->i), Spread::of_facets(cover_.skin.ggx.alpha_x));
}

}  // namespace umbral
