// Small renders and the means of their regions.
#include "real_scenes/region_ratios.h"

#include "app/load_scene.h"

namespace umbral::test {

SmallImage rendered(const std::string& scene_file, int shrink, int spp, std::uint64_t seed) {
  LoadedScene loaded = load_scene(scene_file);
  RenderOptions options;
  options.film = loaded.file.film;
  options.film.width /= shrink;
  options.film.height /= shrink;
  options.film.filter = FilterKind::box;
  options.film.filter_radius = 0.5f;
  options.sampling = {spp, 16, SamplerKind::sobol, seed};
  Integrator& integrator = loaded.integrator(loaded.file.integrator);
  const Scene scene(std::move(loaded.file.scene));
  const auto film = render(scene, integrator, options).film;
  SmallImage image{options.film.width, options.film.height, {}, {}};
  for (int y = 0; y < image.height; ++y)
    for (int x = 0; x < image.width; ++x) {
      const PixelEstimate pixel = film->at(x, y);
      image.mean.push_back(pixel.mean);
      image.standard_error.push_back(pixel.standard_error);
    }
  return image;
}

SmallImage shrunk(const std::string& exr, int shrink) {
  const ExrImage file = read_exr(exr);
  const int width = file.x1 - file.x0;
  SmallImage image{width / shrink, (file.y1 - file.y0) / shrink, {}, {}};
  image.mean.resize(static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.height));
  for (int c = 0; c < 3; ++c) {
    const std::vector<float>& pixels = file.find(std::string(1, "RGB"[c]))->pixels;
    for (int y = 0; y < image.height * shrink; ++y)
      for (int x = 0; x < image.width * shrink; ++x)
        image.mean[static_cast<std::size_t>(y / shrink * image.width + x / shrink)][c] +=
            static_cast<double>(pixels[static_cast<std::size_t>(y * width + x)]) / (shrink * shrink);
  }
  return image;
}

std::vector<RegionRatio> region_ratios(const SmallImage& ours, const SmallImage& theirs, int grid) {
  struct Sums {
    double ours = 0, theirs = 0, variance = 0;
  };
  std::vector<Sums> sums(static_cast<std::size_t>(grid) * static_cast<std::size_t>(grid));
  for (int y = 0; y < ours.height; ++y)
    for (int x = 0; x < ours.width; ++x) {
      const auto i = static_cast<std::size_t>(y * ours.width + x);
      Sums& cell = sums[static_cast<std::size_t>(y * grid / ours.height * grid + x * grid / ours.width)];
      for (int c = 0; c < 3; ++c) {
        cell.ours += ours.mean[i][c];
        cell.theirs += theirs.mean[i][c];
        cell.variance += sqr(ours.standard_error[i][c]);
      }
    }
  std::vector<RegionRatio> ratios;
  for (const Sums& cell : sums)
    ratios.push_back({cell.ours / cell.theirs, std::sqrt(cell.variance) / cell.theirs});
  return ratios;
}

RegionRatio whole_ratio(const SmallImage& ours, const SmallImage& theirs) {
  return region_ratios(ours, theirs, 1)[0];
}

}  // namespace umbral::test
