// Shading normals as colours: the smallest integrator, and the model for a new one.
#pragma once

#include "integrators/integrator.h"

namespace umbral {

// (n + 1)/2 of the shading normal n in world space; black where nothing is hit.
class NormalsIntegrator : public Integrator {
 public:
  static constexpr const char* kind = "normals";
  static constexpr const char* doc = "shading normals as colours, (n + 1)/2";

  void describe(ParameterVisitor&) override {}
  std::vector<std::string> bias_notes() const override { return {"shows normals, not light"}; }
  Spectrum radiance(const Scene& scene, const Ray& ray, Sampler& sampler,
                    std::span<Spectrum> layers) const override;
};

}  // namespace umbral
