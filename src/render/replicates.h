// Independent renders of the same image, with what each cost: the unit of all statistics about whole images.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "render/renderer.h"

namespace umbral {

struct ImageReplicate {
  std::uint64_t seed = 0;
  std::vector<Vec3d> pixels;   // mean radiance, row by row of the crop window from the top
  double wall_seconds = 0;     // of rendering alone
  double cpu_seconds = 0;      // of the whole process, all threads together, in that time
  std::uint64_t rejected = 0;  // samples that were not finite or negative; they count as 0
};

/// The seed of replicate `replicate` of set `set` of a run with `seed`: a hash, so that sets and runs share none.
/// Sets are whatever must be independent of each other, such as two integrators or two numbers of samples.
constexpr std::uint64_t replicate_seed(std::uint64_t seed, std::uint64_t set, std::uint64_t replicate) {
  return hash_combine(hash_combine(hash_combine(0x7265706c69636174, seed), set), replicate);
}

/// Renders with `options`, but for their seed. The image is one replicate whatever number of scrambles
/// `options.sampling.replicates` makes its pixels of. Nothing if the hooks cancelled it.
std::optional<ImageReplicate> render_replicate(const Scene& scene, Integrator& integrator,
                                               RenderOptions options, std::uint64_t seed,
                                               const RenderHooks& hooks = {});

}  // namespace umbral
