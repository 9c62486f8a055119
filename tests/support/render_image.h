// Small renders in tests: from a scene and an integrator to the mean of each pixel.
#pragma once

#include "render/renderer.h"
#include "support/gate.h"

namespace umbral::test {

inline PixelImage image_of(const Film& film) {
  const FilmLayout& layout = film.layout();
  PixelImage image{layout.crop_width(), layout.crop_height(), {}};
  for (int y = layout.y0; y < layout.y1; ++y)
    for (int x = layout.x0; x < layout.x1; ++x) image.pixels.push_back(film.at(x, y).mean);
  return image;
}

// A replicate for the gate: one scramble of `spp` samples (× effort) a pixel, through a box filter one pixel wide.
struct SmallRender {
  const Scene& scene;
  Integrator& integrator;
  SamplerKind sampler = SamplerKind::sobol;
  int spp = 16;
  int size = 16;  // pixels a side

  PixelImage operator()(std::uint64_t seed, int effort) const {
    RenderOptions options;
    options.film = {size, size, FilterKind::box, 0};
    options.sampling = {spp * effort, 1, sampler, seed};
    options.tile = 4;
    const RenderResult result = render(scene, integrator, options);
    EXPECT_EQ(result.film->rejected(), 0u);
    return image_of(*result.film);
  }
};

}  // namespace umbral::test
