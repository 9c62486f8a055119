// How much light one bounce off stretched facets loses: tables over angle, azimuth, roughness, stretch and index.
#pragma once

#include "bsdf/facets/microfacet.h"

namespace umbral {

// As ggx_loss(), ggx_average_loss() and those of interfaces (bsdf/facets/microfacet_albedo.h), for facets that are not round. The
// tables are made row by row, 3 ms each for mirrors and 30 ms for interfaces, when one of their roughness, stretch and
// index is first asked for: four rows for a mirror, eight for an interface. Up to anisotropy 0.9 the error is below 0.01;
// inside interfaces of eta below 1.4, 0.04 where roughness and anisotropy are above 0.8.
float stretched_mirror_loss(const Ggx& ggx, const Vec3& w);
float stretched_mirror_average_loss(const Ggx& ggx);

// What an interface reflects to the outer side of light from there in a single bounce, and the mean.
float stretched_reflected(const Ggx& ggx, const Vec3& w, float eta);
float stretched_average_reflected(const Ggx& ggx, float eta);

float stretched_interface_loss(const Ggx& ggx, const Vec3& w, float eta);  // w.z > 0 is outside
struct AverageLosses {
  float outside, inside;
};
AverageLosses stretched_interface_average_losses(const Ggx& ggx, float eta);

}  // namespace umbral
