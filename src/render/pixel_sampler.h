// PixelSampler: one camera sample of one pixel, from its random numbers to its radiance.
#pragma once

#include "image/film.h"
#include "image/filter.h"
#include "integrators/integrator.h"
#include "scene/settings.h"

namespace umbral {

class PixelSampler {
 public:
  // `scene` and `integrator` must outlive it; the integrator is prepared for the scene.
  PixelSampler(const Scene& scene, const Integrator& integrator, const FilmSettings& film,
               const SamplingSettings& sampling);

  // What one sample found. `id.seed` is ignored in favour of the settings'.
  struct Result {
    Vec2 position;  // on the film; pixels
    Ray ray;
    Spectrum radiance;
  };
  // `layers` as for Integrator::radiance().
  Result sample(SampleId id, std::span<Spectrum> layers) const;

  // What a ray of sample() sees first, added to the sums.
  void add_auxiliary(const Ray& ray, AuxiliarySums& sums) const;

 private:
  const Scene& scene_;
  const Integrator& integrator_;
  Camera camera_;
  Filter filter_;
  SamplingSettings sampling_;
};

// Whether a sample may enter the film: finite and not negative.
inline bool is_valid_radiance(const Spectrum& radiance) {
  return is_finite(radiance) && min_component(radiance) >= 0;
}

}  // namespace umbral
