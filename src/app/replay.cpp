// Single samples and single pixels, in words.
#include "app/replay.h"

#include <fmt/format.h>

namespace umbral {

std::string replayed_sample(const Scene& scene, Integrator& integrator, const RenderOptions& options, int x,
                            int y, std::uint64_t sample) {
  integrator.prepare(scene);
  const auto replicates = static_cast<std::uint64_t>(replicate_count(options));
  const std::vector<std::string> names = integrator.layers();
  std::vector<Spectrum> layers(names.size(), black);
  const SampleId id{0, static_cast<std::uint32_t>(x), static_cast<std::uint32_t>(y),
                    static_cast<std::uint32_t>(sample % replicates), sample / replicates};
  const PixelSampler pixels(scene, integrator, options.film, options.sampling);
  const PixelSampler::Result result = pixels.sample(id, layers);
  const auto line = [](const std::string& name, const auto& v) {
    return fmt::format("  {:<12} {:.9g} {:.9g} {:.9g}\n", name, v[0], v[1], v[2]);
  };
  std::string text = fmt::format("pixel {},{} sample {} (replicate {}, index {} within it, seed {})\n", x, y,
                                 sample, id.replicate, id.index, options.sampling.seed);
  text += fmt::format("  {:<12} {:.9g} {:.9g}\n", "film", result.position.x, result.position.y);
  text += line("origin", result.ray.o) + line("direction", result.ray.d);
  if (const std::optional<Hit> hit = scene.intersect(result.ray))
    text += line("first hit", scene.surface(result.ray, *hit).p);
  for (std::size_t i = 0; i < names.size(); ++i) text += line(names[i], layers[i]);
  text += line("radiance", result.radiance);
  if (!is_valid_radiance(result.radiance)) text += "  rejected: not finite, or negative\n";
  text.pop_back();
  return text;
}

std::string replayed_pixel(const Scene& scene, Integrator& integrator, RenderOptions options, int x, int y) {
  options.crop = Crop{x, y, x + 1, y + 1};
  const RenderResult result = render(scene, integrator, options);
  const PixelEstimate pixel = result.film->at(x, y);
  std::string text = fmt::format("pixel {},{}: {:g} samples in {} replicates\n", x, y, pixel.samples,
                                 result.film->layout().replicates);
  for (int channel = 0; channel < 3; ++channel)
    text += fmt::format("  {}  {:.9g} ± {:.2g} (standard error)\n", "RGB"[channel], pixel.mean[channel],
                        pixel.standard_error[channel]);
  text.pop_back();
  return text;
}

}  // namespace umbral
