// Passes over tiles of pixels.
#include "render/renderer.h"

#include <algorithm>
#include <chrono>
#include <mutex>

#include "core/parallel.h"

namespace umbral {
namespace {

using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point start) {
  return std::chrono::duration<double>(Clock::now() - start).count();
}

FilmLayout film_layout(const Integrator& integrator, const RenderOptions& options) {
  FilmLayout layout;
  layout.width = options.film.width;
  layout.height = options.film.height;
  const Crop crop = options.crop.value_or(Crop{0, 0, layout.width, layout.height});
  layout.x0 = crop.x0;
  layout.y0 = crop.y0;
  layout.x1 = crop.x1;
  layout.y1 = crop.y1;
  layout.replicates = replicate_count(options);
  if (options.layers) layout.layers = integrator.layers();
  layout.auxiliary = options.auxiliary;
  return layout;
}

StopRule stop_rule(const RenderOptions& options) {
  StopRule rule;
  const auto replicates = static_cast<std::uint64_t>(replicate_count(options));
  const auto spp = static_cast<std::uint64_t>(options.sampling.spp);
  if (options.spp_bounds) rule.samples = (spp + replicates - 1) / replicates;
  rule.seconds = options.seconds;
  rule.relative_error = options.relative_error;
  return rule;
}

// One render: what its passes share.
class Render {
 public:
  Render(const Scene& scene, Integrator& integrator, const RenderOptions& options, const RenderHooks& hooks)
      : pixels_(scene, integrator, options.film, options.sampling),
        options_(options),
        hooks_(hooks),
        film_(std::make_unique<Film>(film_layout(integrator, options))),
        schedule_(stop_rule(options)) {}

  RenderResult run() {
    ImageError error;
    while (!cancelled()) {
      const std::uint64_t first = schedule_.done();
      const std::uint64_t count = schedule_.next(seconds_since(start_), error);
      if (count == 0) break;
      pass(first, count, error.relative());
      error = film_->image_error();
      report(1, count, error.relative());
    }
    const std::string reason = rejected_     ? "a rejected sample"
                               : cancelled() ? "interrupted"
                                             : schedule_.reason();
    return {std::move(film_), seconds_since(start_), reason, schedule_.target()};
  }

 private:
  bool cancelled() const {
    return rejected_ || (hooks_.cancelled && hooks_.cancelled->load(std::memory_order_relaxed));
  }

  void pass(std::uint64_t first, std::uint64_t count, double error) {
    const FilmLayout& layout = film_->layout();
    const int columns = (layout.crop_width() + options_.tile - 1) / options_.tile;
    const int rows = (layout.crop_height() + options_.tile - 1) / options_.tile;
    const auto tiles = static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows);
    std::atomic<std::size_t> done{0};
    parallel_for(tiles, [&](std::size_t tile) {
      if (cancelled()) return;
      const int x = layout.x0 + static_cast<int>(tile % columns) * options_.tile;
      const int y = layout.y0 + static_cast<int>(tile / columns) * options_.tile;
      render_tile({x, y, std::min(x + options_.tile, layout.x1), std::min(y + options_.tile, layout.y1)},
                  first, count);
      report(static_cast<double>(++done) / static_cast<double>(tiles), count, error);
    });
  }

  void render_tile(const Crop& tile, std::uint64_t first, std::uint64_t count) {
    const FilmLayout& layout = film_->layout();
    std::vector<Spectrum> sums(layout.replicates), layers(layout.layers.size()), parts(layers.size());
    for (int y = tile.y0; y < tile.y1; ++y)
      for (int x = tile.x0; x < tile.x1; ++x) {
        std::fill(sums.begin(), sums.end(), black);
        std::fill(layers.begin(), layers.end(), black);
        PixelBlock block{sums, static_cast<std::uint32_t>(count), layers, {}};
        for (int replicate = 0; replicate < layout.replicates; ++replicate)
          for (std::uint64_t index = first; index < first + count; ++index)
            sums[replicate] += sample(x, y, replicate, index, parts, layers, block.auxiliary);
        film_->add(x, y, block);
      }
  }

  // The radiance of one sample; its layers, for which `parts` is room, are added to `layers`.
  Spectrum sample(int x, int y, int replicate, std::uint64_t index, std::span<Spectrum> parts,
                  std::span<Spectrum> layers, AuxiliarySums& auxiliary) {
    const SampleId id{0, static_cast<std::uint32_t>(x), static_cast<std::uint32_t>(y),
                      static_cast<std::uint32_t>(replicate), index};
    std::fill(parts.begin(), parts.end(), black);
    const PixelSampler::Result result = pixels_.sample(id, parts);
    if (options_.auxiliary) pixels_.add_auxiliary(result.ray, auxiliary);
    if (!is_valid_radiance(result.radiance)) {
      film_->reject({x, y, replicate, index, result.radiance});
      if (options_.stop_at_rejected) rejected_ = true;
      return black;
    }
    for (std::size_t i = 0; i < parts.size(); ++i) layers[i] += parts[i];
    return result.radiance;
  }

  // At most ten times a second, by whichever thread comes first.
  void report(double share_of_pass, std::uint64_t pass, double error) {
    if (!hooks_.progress) return;
    const std::unique_lock lock(report_mutex_, std::try_to_lock);
    if (!lock) return;
    const double elapsed = seconds_since(start_);
    if (share_of_pass < 1 && elapsed < next_report_) return;
    next_report_ = elapsed + 0.1;
    const double missing = (share_of_pass - 1) * static_cast<double>(pass);
    hooks_.progress({schedule_.progress(missing, elapsed, error), elapsed, error});
  }

  PixelSampler pixels_;
  const RenderOptions& options_;
  const RenderHooks& hooks_;
  std::unique_ptr<Film> film_;
  Schedule schedule_;
  Clock::time_point start_ = Clock::now();
  std::mutex report_mutex_;
  double next_report_ = 0;
  std::atomic<bool> rejected_{false};  // and options_.stop_at_rejected
};

}  // namespace

int replicate_count(const RenderOptions& options) {
  const SamplingSettings& sampling = options.sampling;
  return options.spp_bounds ? std::min(sampling.replicates, sampling.spp) : sampling.replicates;
}

RenderResult render(const Scene& scene, Integrator& integrator, const RenderOptions& options,
                    const RenderHooks& hooks) {
  integrator.prepare(scene);
  return Render(scene, integrator, options, hooks).run();
}

}  // namespace umbral
