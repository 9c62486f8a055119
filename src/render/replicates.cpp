// A render, timed by two clocks.
#include "render/replicates.h"

#include <chrono>

#include <sys/resource.h>

namespace umbral {
namespace {

double wall_seconds() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

double seconds(const timeval& time) {
  return static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_usec);
}

double cpu_seconds() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return seconds(usage.ru_utime) + seconds(usage.ru_stime);
}

}  // namespace

std::optional<ImageReplicate> render_replicate(const Scene& scene, Integrator& integrator,
                                               RenderOptions options, std::uint64_t seed,
                                               const RenderHooks& hooks) {
  options.sampling.seed = seed;
  const double wall = wall_seconds(), cpu = cpu_seconds();
  const RenderResult result = render(scene, integrator, options, hooks);
  ImageReplicate replicate{seed, {}, wall_seconds() - wall, cpu_seconds() - cpu, result.film->rejected()};
  if (hooks.cancelled && hooks.cancelled->load()) return std::nullopt;
  const FilmLayout& layout = result.film->layout();
  replicate.pixels.reserve(layout.pixels());
  for (int y = layout.y0; y < layout.y1; ++y)
    for (int x = layout.x0; x < layout.x1; ++x) replicate.pixels.push_back(result.film->at(x, y).mean);
  return replicate;
}

}  // namespace umbral
