// Integrator: how much light arrives along a camera ray.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "core/sampler.h"
#include "scene/parameter_visitor.h"
#include "scene/scene.h"

namespace umbral {

// An integrator's settings are described as all parameters are (core/parameters.h). Between prepare() and its end
// it does not change, so that any number of threads may ask it.
class Integrator {
 public:
  virtual ~Integrator() = default;

  // Lets the visitor read or replace each setting.
  virtual void describe(ParameterVisitor& visitor) = 0;

  // The names of the parts that add up to radiance(), if it can tell them apart.
  virtual std::vector<std::string> layers() const { return {}; }

  // In words, what the present settings leave out of the rendering equation or add to it; empty if unbiased.
  virtual std::vector<std::string> bias_notes() const { return {}; }

  // Called once before a render of `scene`.
  virtual void prepare(const Scene& scene) { static_cast<void>(scene); }

  // One estimate of the radiance that arrives at ray.o against ray.d (unit). `layers` is empty, or has one entry
  // for each of layers(), to which the parts are added.
  virtual Spectrum radiance(const Scene& scene, const Ray& ray, Sampler& sampler,
                            std::span<Spectrum> layers) const = 0;
};

}  // namespace umbral
