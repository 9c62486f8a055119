// Rough panes: light is reflected at a facet or goes through it unbent, spread as the reflection is.
#pragma once

#include "bsdf/layers/skin.h"

namespace umbral {

// f on the side of the viewer is F D G₂/(4 cos θo cos θi), on the other (1 − F) τ D G₂/(4 cos θo cos θi) of wi mirrored at the
// surface, as glTF's KHR_materials_transmission has it for walls without thickness. What goes on after a single bounce is
// given back diffusely to both sides as the conductor's is, in the shares F_avg and 1 − F_avg.
struct Pane {
  Spectrum transmittance;
  Skin skin;

  bool only_delta() const { return skin.is_smooth(); }

  Spectrum f_cos(const Vec3& wo, const Vec3& wi) const;
  float pdf(const Vec3& wo, const Vec3& wi) const;
  std::optional<BsdfSample> sample(const Vec3& wo, float u1, const Vec2& u2) const;
};

}  // namespace umbral
