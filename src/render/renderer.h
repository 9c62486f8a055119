// Renderer: drives an integrator over a film.
#pragma once

#include <atomic>
#include <functional>
#include <memory>
#include <optional>

#include "render/pixel_sampler.h"
#include "render/schedule.h"

namespace umbral {

struct Crop {
  int x0, y0, x1, y1;  // pixels; x0 ≤ x < x1, y0 ≤ y < y1
};

struct RenderOptions {
  FilmSettings film;
  SamplingSettings sampling;  // spp is how many at most, rounded up to a whole number a replicate
  bool spp_bounds = true;     // false: spp does not bound the render, the rules below do
  double seconds = std::numeric_limits<double>::infinity();
  double relative_error = 0;  // target, see Schedule; 0 asks for none, any other needs two replicates
  std::optional<Crop> crop;
  bool layers = false;            // keep the integrator's layers apart
  bool auxiliary = false;         // albedo, normal and depth of the first hit
  int tile = 16;                  // pixels a side; changes nothing in the image
  bool stop_at_rejected = false;  // end soon after the first sample that is not finite or is negative
};

// What a render reports while it runs, from any of its threads but never from two at a time.
struct RenderProgress {
  double share;           // of the work, 0 … 1
  double elapsed;         // seconds
  double relative_error;  // RMS standard error over mean, as of the last whole pass; infinite before it
};

struct RenderHooks {
  std::function<void(const RenderProgress&)> progress;  // may be empty
  const std::atomic<bool>* cancelled = nullptr;         // ends the render soon after it becomes true
};

struct RenderResult {
  std::unique_ptr<Film> film;
  double seconds;           // wall clock, of sampling
  std::string stop_reason;  // in words
  TargetError target;       // without looks unless a target error was asked for
};

// How many replicates a render has: never more than samples, where these are bounded.
int replicate_count(const RenderOptions& options);

// A render's pixels depend on scene, settings and integrator alone: not on threads, tiles or passes, as long as
// the same number of samples is reached.
RenderResult render(const Scene& scene, Integrator& integrator, const RenderOptions& options,
                    const RenderHooks& hooks = {});

}  // namespace umbral
