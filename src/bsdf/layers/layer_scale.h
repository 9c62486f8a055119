// How much more the facets under a layer must reflect than the layer lets pass, so that nothing is lost between them.
#pragma once

#include "bsdf/layers/fuzz.h"

namespace umbral {

// Facets that lose nothing scatter light by an operator B with B 1 = 1, and the layer lets pass T(θ). Of all symmetric
// d(wo) B(wo, wi) d(wi) one sends back all that got in: that with d (B d) = T [after Sinkhorn 1967]. Given is
// g = d/√T, which is 1 for mirrors, where T is the same on the way in and out; `alpha` is that of the facets. From tables,
// made when they are first used.

// Under a clear skin of index eta, 1 … 10, and the width `skin_alpha` (0: smooth).
float skin_scale(float cos_theta, float alpha, float skin_alpha, float eta);
// Under fuzz of that strength, 0 … 1.
float fuzz_scale(float cos_theta, float alpha, const Fuzz& fuzz, float strength);

}  // namespace umbral
