// Shading normals as colours.
#include "integrators/normals.h"

namespace umbral {

Spectrum NormalsIntegrator::radiance(const Scene& scene, const Ray& ray, Sampler&,
                                     std::span<Spectrum>) const {
  const std::optional<Hit> hit = scene.intersect(ray);
  if (!hit) return black;
  const Vec3 n = scene.surface(ray, *hit).shading.n;
  return rgb(n.x + 1, n.y + 1, n.z + 1) / 2.0f;
}

}  // namespace umbral
