// Replays single samples of a render, bit for bit.
#pragma once

#include <string>

#include "render/renderer.h"

namespace umbral {

// What sample number `sample` of pixel (x, y) of that render does, in words: its ray and radiance, by layers.
// Samples are numbered as they are dealt to the replicates: number s is index s / R of replicate s mod R.
std::string replayed_sample(const Scene& scene, Integrator& integrator, const RenderOptions& options, int x,
                            int y, std::uint64_t sample);

// The estimate of that pixel alone.
std::string replayed_pixel(const Scene& scene, Integrator& integrator, RenderOptions options, int x, int y);

}  // namespace umbral
