// From (pixel, replicate, index) to a radiance.
#include "render/pixel_sampler.h"

namespace umbral {

PixelSampler::PixelSampler(const Scene& scene, const Integrator& integrator, const FilmSettings& film,
                           const SamplingSettings& sampling)
    : scene_(scene),
      integrator_(integrator),
      camera_(scene.camera(), film.width, film.height),
      filter_{film.filter, film.filter_radius},
      sampling_(sampling) {}

PixelSampler::Result PixelSampler::sample(SampleId id, std::span<Spectrum> layers) const {
  id.seed = sampling_.seed;
  Sampler sampler(sampling_.sampler, id);
  const Vec2 center{static_cast<float>(id.x) + 0.5f, static_cast<float>(id.y) + 0.5f};
  const Vec2 position = center + filter_.sample(sampler.next2d());
  const Vec2 lens = camera_.has_lens() ? sampler.next2d() : Vec2{0, 0};
  const Ray ray = camera_.ray(position, lens);
  return {position, ray, integrator_.radiance(scene_, ray, sampler, layers)};
}

void PixelSampler::add_auxiliary(const Ray& ray, AuxiliarySums& sums) const {
  const std::optional<Hit> hit = scene_.intersect(ray);
  if (!hit) return;
  const Surface surface = scene_.surface(ray, *hit);
  LobeStack textured;
  sums.albedo += albedo(scene_.bsdf(surface, textured));
  sums.normal += surface.shading.n;
  sums.depth += hit->t * dot(ray.d, camera_.forward());
  ++sums.hits;
}

}  // namespace umbral
