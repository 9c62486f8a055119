// What layers let pass, by how widely the light beneath them is scattered.
#include "bsdf/layers/cover.h"

#include "bsdf/layers/layer_scale.h"

namespace umbral {
namespace {

float passed_by(const Skin& skin, float cos_theta) {
  return std::max(0.0f, 1 - skin.albedo(std::abs(cos_theta)).g);
}

// By how much more light gets through two layers on facets than each scaling by itself accounts for, as both let pass more along
// the normal: as on matte bodies where facets scatter widely, not at all on mirrors.
float both_lean(Spread of_facets, const Skin& skin) {
  if (of_facets.lean() == 0) return 1;
  return 1 + std::min(1.0f, 3 * std::sqrt(of_facets.alpha())) * of_facets.lean() * skin.lean_of_passed();
}

}  // namespace

Passage::Passage(const Cover& cover, float cos_o, float cos_i)
    : cover_(cover),
      cos_o_(std::abs(cos_o)),
      cos_i_(std::abs(cos_i)),
      passed_o_(passed_by(cover.skin, cos_o_)),
      passed_i_(cos_o_ == cos_i_ ? passed_o_ : passed_by(cover.skin, cos_i_)) {}

Spectrum Passage::of(Spread spread) const {
  const Skin& skin = cover_.skin;
  if (spread.is_matte()) {
    const float mean = std::max(1e-6f, 1 - skin.average_albedo().g);
    const float of_part = spread.lean() == 0 ? mean : mean * (1 + spread.lean() * skin.lean_of_passed());
    return tinted(passed_o_ * passed_i_ / of_part, mean / sqr(skin.interface.eta));
  }
  const float skin_alpha = skin.is_smooth() ? 0 : skin.round_alpha();
  const auto scale = [&](float c) { return skin_scale(c, spread.alpha(), skin_alpha, skin.interface.eta); };
  const float passed = std::sqrt(passed_o_ * passed_i_);
  return tinted(passed * scale(cos_o_) * scale(cos_i_) / both_lean(spread, skin), passed);
}

Spectrum Passage::of_mirror() const { return tinted(passed_o_, passed_o_); }

Spectrum Passage::tinted(float scale, float out) const {
  const Spectrum tint = cover_.transmittance * cover_.transmittance;
  const Spectrum again = cover_.albedo_beneath * tint * (1 - out);
  const Spectrum covered = tint * (scale * out) / glm::max(1.0f - again, Spectrum(1e-6f));
  return (1 - cover_.share) * white + cover_.share * covered;
}

}  // namespace umbral
