// Sentences and JSON about a render.
#include "app/render_report.h"

#include <sys/resource.h>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "app/number_text.h"
#include "umbral_version.h"

namespace umbral {
namespace {

double peak_mebibytes() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return static_cast<double>(usage.ru_maxrss) / 1024;
}

}  // namespace

std::string tails_text(const FilmImage& image) {
  std::string text;
  if (image.has_heavy_tails())
    text = fmt::format(
        "heavy tails (index {:.2f}): error bars are too narrow and means rather too low; take more samples",
        image.tail_index);
  if (const std::size_t fireflies = image.firefly_count(); fireflies > 0)
    text += fmt::format("{}{} of {} pixels hang on one replicate (fireflies, channel firefly.Y)",
                        text.empty() ? "" : "; ", fireflies, image.pixels.size());
  return text;
}

Provenance provenance(const RenderJob& job, const RenderResult& result, const Scene& scene) {
  const RenderOptions& options = job.options;
  const Filter filter{options.film.filter, options.film.filter_radius};
  Provenance p;
  p.version = version;
  p.scene = job.scene_path;
  p.scene_hash = fmt::format("{:016x}", job.scene_hash);
  p.integrator = job.integrator_call;
  p.sampler = sampler_names()[static_cast<std::size_t>(options.sampling.sampler)];
  p.filter = fmt::format("{} {:g}", EnumNames<FilterKind>::names[static_cast<std::size_t>(filter.kind)],
                         filter.effective_radius());
  p.seeds = {options.sampling.seed};
  p.render_seconds = result.seconds;
  p.stop_reason = result.stop_reason;
  p.bias_notes = job.bias_notes;
  if (!job.left_out.empty()) p.extra["leftOut"] = fmt::format("{}", fmt::join(job.left_out, "; "));
  if (!job.approximated.empty())
    p.extra["approximated"] = fmt::format("{}", fmt::join(job.approximated, "; "));
  p.extra["features"] = fmt::format("{}", fmt::join(scene.features(), ", "));
  return p;
}

double efficiency(const ImageError& error, double seconds) {
  return 1 / (error.relative() * error.relative() * seconds);
}

std::string summary_line(const FilmImage& image, const Scene& scene) {
  const ImageError& error = image.error;
  const double seconds = image.provenance.render_seconds;
  const std::vector<std::string> features = scene.features();
  std::string text = fmt::format("{:.6g} spp in {:.3g} s ({})", image.samples_per_pixel(), seconds,
                                 image.provenance.stop_reason);
  if (std::isfinite(error.rms_standard_error)) {
    text +=
        fmt::format("; error {} (RMS standard error of a pixel over the mean); mean {:.6g} ± {:.2g} (95 %)",
                    percent_text(error.relative()), error.mean, error.half_width());
    if (error.relative() > 0) text += fmt::format("; efficiency {:.3g}/s", efficiency(error, seconds));
  } else {
    text += fmt::format("; mean {:.6g}; error unknown: it takes two replicates at least", error.mean);
  }
  if (const std::string tails = tails_text(image); !tails.empty()) text += "; " + tails;
  text += fmt::format("; uses {}",
                      features.empty() ? "nothing special" : fmt::format("{}", fmt::join(features, ", ")));
  if (!image.provenance.bias_notes.empty())
    text += fmt::format("; biased: {}", fmt::join(image.provenance.bias_notes, "; "));
  return text;
}

std::string statistics_text(const FilmImage& image, const Scene& scene) {
  const double seconds = image.provenance.render_seconds;
  return fmt::format(
      "  paths          {:.4g} in all, {:.4g} million a second\n"
      "  pixel variance {:.4g} of the mean over {} replicates\n"
      "  lights         {}\n"
      "  memory         {:.1f} MiB at most, {:.1f} MiB of it Embree's",
      image.error.samples, image.error.samples / seconds / 1e6, image.error.pixel_variance(),
      image.layout.replicates, scene.light_count(), peak_mebibytes(),
      static_cast<double>(scene.accel_bytes()) / (1 << 20));
}

std::string rejected_text(const Film& film, const RenderJob& job) {
  if (film.rejected() == 0) return {};
  std::string text = fmt::format(
      "{} samples were not finite or negative; they count as 0 and the image is darker by that. The first:",
      film.rejected());
  const auto replicates = static_cast<std::uint64_t>(film.layout().replicates);
  for (const RejectedSample& sample : film.first_rejected())
    text += fmt::format(
        "\n  ({:g}, {:g}, {:g}): umbral render {} --integrator {} --seed {} --spp {} --pixel {},{} --sample "
        "{}",
        sample.value.r, sample.value.g, sample.value.b, job.scene_path, job.integrator,
        job.options.sampling.seed, job.options.sampling.spp, sample.x, sample.y,
        sample.index * replicates + static_cast<std::uint64_t>(sample.replicate));
  return text;
}

std::string summary_json(const FilmImage& image, const Scene& scene, const TargetError& target,
                         const std::string& exr, const std::string& png) {
  const ImageError& error = image.error;
  const Provenance& p = image.provenance;
  const nlohmann::ordered_json json{
      {"exr", exr},
      {"png", png},
      {"version", p.version},
      {"scene", p.scene},
      {"sceneHash", p.scene_hash},
      {"integrator", p.integrator},
      {"sampler", p.sampler},
      {"seeds", p.seeds},
      {"width", image.layout.width},
      {"height", image.layout.height},
      {"replicates", image.layout.replicates},
      {"samplesPerPixel", image.samples_per_pixel()},
      {"samplesRejected", image.samples_rejected},
      {"seconds", p.render_seconds},
      {"stopReason", p.stop_reason},
      {"mean", error.mean},
      {"meanHalfWidth95", number_or_null(error.half_width())},
      {"rmsStandardError", number_or_null(error.rms_standard_error)},
      {"relativeError", number_or_null(error.relative())},
      {"targetReached", target.looks > 0 ? nlohmann::json(target.reached) : nlohmann::json()},
      {"relativeErrorLimit95", number_or_null(target.limit)},
      {"tailIndex", image.tail_index},
      {"fireflies", image.firefly_count()},
      {"efficiency", number_or_null(efficiency(error, p.render_seconds))},
      {"features", scene.features()},
      {"biasNotes", p.bias_notes},
  };
  return json.dump(2);
}

}  // namespace umbral
