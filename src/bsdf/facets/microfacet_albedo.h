// How much light one bounce off a rough surface loses: tables over angle, roughness and index, made when first used.
#pragma once

#include "bsdf/facets/microfacet.h"

namespace umbral {

// The share of light from w that a surface of perfect mirrors (F = 1) does not send on after a single bounce, as it goes
// on between the facets: 1 − E(w); and its mean over the hemisphere, 2 ∫ (1 − E) cos θ d cos θ (for stretched surfaces
// over the azimuth too). The error of 1 − E is below 0.003; 0.01 for stretched surfaces up to anisotropy 0.9.
float ggx_loss(const Ggx& ggx, const Vec3& w);
float ggx_average_loss(const Ggx& ggx);

// The same for the rough interface between dielectrics, without stretch (bsdf/facets/stretched_albedo.h); eta: index of the inner over that of the outer side, 1 … 10.
// The error is below 0.01, of what is reflected below 0.003.
struct InterfaceShares {
  float reflected;  // of light from outside, to the same side
  float lost;       // what a single bounce neither reflects nor refracts
};
InterfaceShares interface_shares(float cos_theta, float alpha, float eta);  // cos_theta > 0 is outside
struct InterfaceAverages {
  float reflected, lost_outside, lost_inside;
};
InterfaceAverages interface_averages(float alpha, float eta);

// Directions (z ≥ 0) about in proportion to loss times cosine, and their density per solid angle. The loss goes with
// 1/(cos² θ + alpha²) roughly, so that for narrow highlights the cosine alone would miss the band above the horizon.
Vec3 sample_lossy_direction(const Vec2& u, float alpha);
float lossy_direction_pdf(float cos_theta, float alpha);

}  // namespace umbral
