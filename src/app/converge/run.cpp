// Variants take turns, replicate by replicate, so that what else the machine does slows all of them alike.
#include "app/converge/run.h"

#include <algorithm>
#include <chrono>

#include <fmt/format.h>

#include "analysis/comparison.h"
#include "app/arguments.h"
#include "app/replicate_planes.h"

namespace umbral {
namespace {

// The most variance of an error's logarithm that may be the reference's: its noise is the same at all numbers of
// samples, and would tilt the slope.
constexpr double most_blur = 0.01;

using SteadyClock = std::chrono::steady_clock;

double mean_of_image(const Planes& image) {
  double sum = 0;
  for (const std::vector<float>& channel : image.channels)
    for (const float value : channel) sum += value;
  return sum / (3 * static_cast<double>(image.pixels()));
}

double mean_of_numbers(const std::vector<double>& values) {
  double sum = 0;
  for (const double value : values) sum += value;
  return sum / static_cast<double>(values.size());
}

// What one variant's replicates of one number of samples left.
struct Level {
  std::vector<Planes> images;
  std::vector<double> wall, cpu;
};

class Converging {
 public:
  Converging(const Scene& scene, const std::vector<Variant>& variants, const ConvergeSettings& settings,
             const RenderHooks& hooks)
      : scene_(scene), variants_(variants), settings_(settings), hooks_(hooks) {
    const FilmSettings& film = variants[0].film;
    const Crop crop = settings.crop.value_or(Crop{0, 0, film.width, film.height});
    result_.width = crop.x1 - crop.x0;
    result_.height = crop.y1 - crop.y0;
    if (settings.reference) noise_ = noise_of(settings.reference->image);
    for (const Variant& variant : variants) {
      const auto sampler = static_cast<std::size_t>(variant.sampling.sampler);
      result_.curves.push_back(
          {variant.name, variant.call, sampler_names()[sampler], variant.integrator->bias_notes()});
    }
    for (int spp = settings.first_spp; spp <= settings.last_spp; spp *= 2) work_ += spp;
  }

  ConvergeResult run() {
    warm_up();
    double last_level = 0;
    for (int spp = settings_.first_spp; spp <= settings_.last_spp; spp *= 2) {
      const double begin = elapsed();
      if (begin + 2 * last_level > settings_.seconds) {
        result_.end = ConvergeEnd::time;
        break;
      }
      if (!level(spp)) {
        result_.end = ConvergeEnd::interrupted;
        break;
      }
      last_level = elapsed() - begin;
    }
    in_units_of_mean();
    result_.seconds = elapsed();
    return std::move(result_);
  }

 private:
  double elapsed() const { return std::chrono::duration<double>(SteadyClock::now() - start_).count(); }

  // The first render of a scene meets cold caches: its time is nobody's.
  void warm_up() {
    for (const Variant& variant : variants_)
      render_replicate(scene_, *variant.integrator, options(variant, settings_.first_spp), 1,
                       {{}, hooks_.cancelled});
  }

  RenderOptions options(const Variant& variant, int spp) const {
    RenderOptions options;
    options.film = variant.film;
    options.sampling = variant.sampling;
    options.sampling.spp = spp;
    options.crop = settings_.crop;
    return options;
  }

  // False if it was cancelled.
  bool level(int spp) {
    std::vector<Level> levels(variants_.size());
    for (int r = 0; r < settings_.replicates; ++r)
      for (std::size_t v = 0; v < variants_.size(); ++v) {
        const std::uint64_t set = v << 32 | static_cast<std::uint32_t>(spp);
        const auto seed = replicate_seed(settings_.seed, set, static_cast<std::uint64_t>(r));
        const auto replicate = render_replicate(scene_, *variants_[v].integrator, options(variants_[v], spp),
                                                seed, {{}, hooks_.cancelled});
        if (!replicate) return false;
        levels[v].images.push_back(planes_of(*replicate, result_.width, result_.height));
        levels[v].wall.push_back(replicate->wall_seconds);
        levels[v].cpu.push_back(replicate->cpu_seconds);
        result_.curves[v].rejected += replicate->rejected;
        report(spp);
      }
    for (std::size_t v = 0; v < levels.size(); ++v) add_point(spp, levels[v], result_.curves[v]);
    return true;
  }

  void report(int spp) {
    done_ += static_cast<double>(spp) / settings_.replicates / static_cast<double>(variants_.size());
    if (!hooks_.progress) return;
    const double share = std::max(done_ / work_, elapsed() / settings_.seconds);
    hooks_.progress({std::min(share, 1.0), elapsed(), infinity});
  }

  void add_point(int spp, const Level& level, ConvergeCurve& curve) {
    const std::optional<Reference>& reference = settings_.reference;
    const ReplicateProducts products(level.images, reference ? reference->image.mean : Planes());
    const auto variance = reference ? products.log_error(noise_) : products.log_variance();
    const double blur = noise_.variance_of_mean_square / sqr(products.error(noise_));
    if (variance && blur < most_blur) {
      const std::vector<double>& seconds = settings_.clock == Clock::wall ? level.wall : level.cpu;
      curve.points.push_back({static_cast<double>(spp), *variance, geometric_mean(seconds)});
      curve.wall_seconds.push_back(mean_of_numbers(level.wall));
      curve.cpu_seconds.push_back(mean_of_numbers(level.cpu));
    } else {
      curve.unmeasured.push_back(spp);
    }
    ReplicateSum sum(result_.width, result_.height, tested_regions(result_.width, result_.height));
    for (const Planes& image : level.images) sum.add(image);
    curve.finest = sum.finish();
  }

  void in_units_of_mean() {
    if (result_.curves[0].finest.mean.empty()) return;
    const Planes& image =
        settings_.reference ? settings_.reference->image.mean : result_.curves[0].finest.mean;
    result_.mean = mean_of_image(image);
    if (!(result_.mean > 0))
      refuse("the image is black: relative to its mean, which is 0, there is no error to speak of");
    for (ConvergeCurve& curve : result_.curves) {
      if (curve.points.empty() && !settings_.reference)
        refuse("'" + curve.name + "' has no noise: all its replicates are the same, and nothing converges");
      for (ConvergencePoint& point : curve.points) point.variance.log -= 2 * std::log(result_.mean);
    }
  }

  const Scene& scene_;
  const std::vector<Variant>& variants_;
  const ConvergeSettings& settings_;
  const RenderHooks& hooks_;
  ReferenceNoise noise_;
  ConvergeResult result_;
  SteadyClock::time_point start_ = SteadyClock::now();
  double work_ = 0, done_ = 0;  // samples a pixel and variant
};

}  // namespace

// The three channels of a pixel are taken for fully correlated, which the mean square's variance is largest for: with vᵢ
// the mean variance of pixel i and ν degrees of freedom behind it, Var = Σ 2 vᵢ² (1 + 1/ν)/n².
ReferenceNoise noise_of(const EstimatedImage& reference) {
  ReferenceNoise noise;
  if (reference.variance.empty()) return noise;
  const auto pixels = static_cast<double>(reference.variance.pixels());
  for (std::size_t i = 0; i < reference.variance.pixels(); ++i) {
    const Vec3d channels = reference.variance.at(i);
    const double variance = (channels.r + channels.g + channels.b) / 3;
    noise.variance += variance / pixels;
    noise.variance_of_mean_square +=
        2 * variance * variance * (1 + 1 / reference.degrees_of_freedom) / (pixels * pixels);
  }
  return noise;
}

bool has_points(const ConvergeResult& result) {
  return std::any_of(result.curves.begin(), result.curves.end(),
                     [](const ConvergeCurve& curve) { return !curve.points.empty(); });
}

ConvergeResult converge(const Scene& scene, const std::vector<Variant>& variants,
                        const ConvergeSettings& settings, const RenderHooks& hooks) {
  return Converging(scene, variants, settings, hooks).run();
}

}  // namespace umbral
