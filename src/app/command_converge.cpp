// `umbral converge`: how fast the noise of a scene falls, and under which of several settings it does so fastest.
#include <filesystem>

#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include "analysis/estimated_file.h"
#include "app/arguments.h"
#include "app/commands.h"
#include "app/converge/report.h"
#include "app/converge/sentences.h"
#include "app/exit_code.h"
#include "app/watched_render.h"
#include "core/names.h"
#include "core/parallel.h"
#include "image/atomic_file.h"

namespace umbral {
namespace {

struct Arguments {
  std::string scene, size, spp_range = "4..256", clock = "wall", target_error;
  VariantArguments variants;
  std::string reference, oracle;
  ConvergeSettings settings{};
  Expectations expectations{};
  std::string html, svg, json, junit;
  int threads = 0;
  bool quiet = false;
  ReadOptions read;
};

// "4..1024": at least three numbers of samples, each twice the one before.
void apply_range(const std::string& text, ConvergeSettings& settings) {
  int first = 0, last = 0, used = 0;
  if (std::sscanf(text.c_str(), "%d..%d%n", &first, &last, &used) != 2 ||
      static_cast<std::size_t>(used) != text.size() || first < 1 || last > (1 << 28))
    refuse("--spp-range wants FIRST..LAST samples a pixel, as in 4..256, not '" + text + "'");
  if (last / first < 4)
    refuse("--spp-range " + text + " holds fewer than three numbers of samples: it takes LAST ≥ 4·FIRST");
  settings.first_spp = first;
  settings.last_spp = last;
}

// "0.5" or "0.5,0.25,0.1": an image of that radiance everywhere.
std::optional<Planes> constant_image(const std::string& text, int width, int height) {
  Vec3d colour{0};
  int used = 0;
  const auto whole = [&] { return static_cast<std::size_t>(used) == text.size(); };
  if (std::sscanf(text.c_str(), "%lf,%lf,%lf%n", &colour.x, &colour.y, &colour.z, &used) != 3 || !whole()) {
    used = 0;
    if (std::sscanf(text.c_str(), "%lf%n", &colour.x, &used) != 1 || !whole()) return std::nullopt;
    colour = Vec3d(colour.x);
  }
  for (int c = 0; c < 3; ++c)
    if (!(colour[c] >= 0) || !std::isfinite(colour[c]))
      refuse("--oracle wants a radiance, not '" + text + "'");
  Planes planes(width, height);
  for (int c = 0; c < 3; ++c)
    std::fill(planes.channels[c].begin(), planes.channels[c].end(), static_cast<float>(colour[c]));
  return planes;
}

void require_fit(const EstimatedFile& file, const FilmSettings& film) {
  const Planes& mean = file.image.mean;
  if (mean.width == film.width && mean.height == film.height && file.x0 == 0 && file.y0 == 0) return;
  throw UnfitImage(UnfitReason::size,
                   fmt::format("{} has {} x {} pixels, and the scene's image {} x {}: choose its --size",
                               file.path, mean.width, mean.height, film.width, film.height));
}

void require_own_noise(const EstimatedFile& file, const LoadedScene& scene) {
  if (file.image.source == ErrorSource::none)
    throw UnfitImage(UnfitReason::no_error,
                     file.path +
                         " has no error bars (channels stderr.R/G/B): if it is exact, or far more so "
                         "than these renders, give it as --oracle");
  bool noisy = false;
  for (const std::vector<float>& values : file.image.variance.channels)
    for (const float value : values) noisy |= value > 0;
  if (!noisy)
    throw UnfitImage(UnfitReason::no_variance,
                     file.path +
                         ": its standard error is 0 in every pixel, which no render has; if it is "
                         "exact, give it as --oracle");
  const std::string hash = fmt::format("{:016x}", scene.file.hash);
  if (file.is_ours() && file.scene_hash != hash)
    fmt::print(stderr, "warning: {} was rendered from other files than this scene's\n", file.path);
}

std::optional<Reference> reference_of(const Arguments& a, const LoadedScene& scene,
                                      const FilmSettings& film) {
  if (!a.reference.empty() && !a.oracle.empty()) refuse("give --reference or --oracle, not both");
  if (!a.oracle.empty()) {
    if (auto constant = constant_image(a.oracle, film.width, film.height))
      return Reference{"the oracle " + a.oracle, {std::move(*constant), ErrorSource::exact}};
    EstimatedFile file = read_estimated_file(a.oracle);
    require_fit(file, film);
    return Reference{a.oracle, {std::move(file.image.mean), ErrorSource::exact}};
  }
  if (a.reference.empty()) return std::nullopt;
  EstimatedFile file = read_estimated_file(a.reference);
  require_fit(file, film);
  require_own_noise(file, scene);
  return Reference{a.reference, std::move(file.image)};
}

// A replicate is a whole image, so that its samples are one set unless asked for otherwise.
std::vector<Variant> variants_of(const Arguments& arguments, LoadedScene& scene) {
  if (!arguments.size.empty()) apply_size(arguments.size, scene.file.film);
  scene.file.sampling.replicates = 1;
  std::vector<Variant> result = variants(scene, arguments.variants);
  for (const std::string& text : arguments.variants.settings)
    for (const char* name : {"sampling.spp=", "sampling.seed="})
      if (text.starts_with(name)) refuse("--set " + text + ": --spp-range and --seed say that here");
  for (const Variant& variant : result)
    if (arguments.settings.first_spp % variant.sampling.replicates != 0)
      refuse(fmt::format("'{}' makes a pixel of {} parts: --spp-range must begin at a multiple of that",
                         variant.name, variant.sampling.replicates));
  return result;
}

ConvergeResult rendered(const Scene& scene, const std::vector<Variant>& all, const Arguments& arguments) {
  const WatchedRender watched(arguments.quiet);
  return converge(scene, all, arguments.settings, watched.hooks());
}

void write_reports(const Arguments& arguments, const ConvergeReport& report) {
  if (!arguments.html.empty()) write_page(arguments.html, page_of(report));
  if (!arguments.svg.empty() && has_points(report.result))
    write_file(arguments.svg, svg_file(samples_plot(report)));
  if (!arguments.json.empty()) write_file(arguments.json, json_text(report));
  if (!arguments.junit.empty()) write_file(arguments.junit, junit_xml(suite_of(report)));
}

bool enough_points(const ConvergeResult& result) {
  for (const ConvergeCurve& curve : result.curves)
    if (curve.points.size() < 3) return false;
  return true;
}

int command(Arguments arguments) {
  std::optional<ThreadLimit> threads;
  if (arguments.threads > 0) threads.emplace(arguments.threads);
  apply_range(arguments.spp_range, arguments.settings);
  arguments.settings.clock = arguments.clock == "cpu" ? Clock::cpu : Clock::wall;
  if (!arguments.target_error.empty())
    arguments.expectations.target_error = parsed_share(arguments.target_error, "--target-error");
  LoadedScene loaded = load_scene(arguments.scene, arguments.read, arguments.quiet);
  if (!arguments.quiet) print_warnings(loaded.file);
  const std::vector<Variant> all = variants_of(arguments, loaded);
  require_variants_of(arguments.expectations, all);
  arguments.settings.reference = reference_of(arguments, loaded, all[0].film);
  if (arguments.expectations.equal && all.size() < 2 && !arguments.settings.reference)
    refuse("--expect-equal: there is nothing to be equal to: give --reference, --oracle or several variants");
  for (const std::string& path : {arguments.html, arguments.svg, arguments.json, arguments.junit})
    if (!path.empty()) const AtomicFile probe(path);  // fails now rather than after a long render
  const Scene scene = built_scene(std::move(loaded.file.scene), arguments.quiet);

  const ConvergeResult result = rendered(scene, all, arguments);
  if (result.curves[0].finest.mean.empty()) {
    fmt::print(stderr,
               "interrupted before the first number of samples was done: there is nothing to tell, and "
               "nothing is written\n");
    return exit_interrupted;
  }
  const Findings found = findings(result, arguments.settings, arguments.expectations);
  const ConvergeReport report{arguments.scene, result, arguments.settings, arguments.expectations, found};
  if (!arguments.quiet) fmt::print("{}\n{}", headline(report), convergence_text(report));
  write_reports(arguments, report);
  if (result.end == ConvergeEnd::interrupted) return exit_interrupted;
  const int code = exit_code_of(found.checks);
  return code == exit_success && !enough_points(result) ? static_cast<int>(exit_not_reached) : code;
}

void add_render_options(CLI::App& converge, Arguments& a) {
  converge.add_option("scene", a.scene, scene_help())->required();
  add_variant_options(converge, a.variants);
  add_read_options(converge, a.read);
  converge.add_option("--replicates", a.settings.replicates, "independent renders of each number of samples")
      ->check(CLI::Range(16, 1024))
      ->capture_default_str();
  converge.add_option("--spp-range", a.spp_range, "samples per pixel, doubling from FIRST to LAST")
      ->capture_default_str();
  converge
      .add_option("--time-limit", a.settings.seconds, "seconds: no more samples are begun that end later")
      ->check(number_above(0));
  converge.add_option("--size", a.size, "image size, WIDTHxHEIGHT");
  converge.add_option("--seed", a.settings.seed, "another seed gives independent renders")
      ->check(whole_number());
  converge.add_option("--threads", a.threads, "default: all")->check(CLI::Range(1, 4096));
  converge.add_option("--clock", a.clock, "wall, or cpu: of all threads, which other programs disturb less")
      ->check(CLI::IsMember({"wall", "cpu"}))
      ->capture_default_str();
}

void add_expectations(CLI::App& converge, Arguments& a) {
  converge.add_option("--reference", a.reference, "an EXR with error bars, to take errors about");
  converge.add_option("--oracle", a.oracle,
                      "the exact image: an EXR, or a radiance such as 0.5 or 0.5,0.3,0.1");
  converge.add_option("--target-error", a.target_error,
                      "tells the samples and seconds to this RMS error relative to the mean, such as 1%");
  converge.add_option(
      "--expect-slope", a.expectations.slope,
      "the variance of every variant falls at least with this power of the samples, such as -1");
  converge
      .add_option("--expect-faster", a.expectations.faster,
                  "the variant of this NAME is faster than the first; NAME:FACTOR: so many times")
      ->take_all()
      ->allow_extra_args(false);
  converge.add_flag("--expect-equal", a.expectations.equal,
                    "every variant converges to the reference, or to the image of the first");
}

void add_reports(CLI::App& converge, Arguments& a) {
  converge.add_option("--html", a.html, "a page to write, with plots; it holds all it shows");
  converge.add_option("--svg", a.svg, "the plot of error against samples alone");
  converge.add_option("--json", a.json, "the numbers");
  converge.add_option("--junit", a.junit, "JUnit XML for continuous integration, one test an expectation");
  converge.add_flag("--quiet", a.quiet, "no progress, no text: the exit code tells");
  converge.footer(
      "Renders every variant in independent whole images of doubling numbers of samples. Errors are relative "
      "to\n"
      "the mean of the image; slopes are of the variance, so -1 is Monte Carlo. A variant is called faster "
      "only\n"
      "where the 95 % interval of the ratio of times to the same error excludes 1.\n"
      "Exit code: 0 what is expected holds, 1 it does not, 4 too few samples to tell or a target error that "
      "was\n"
      "not reached; 2 bad arguments or files, 3 unwritable output, 5 a reference of another size, 6 without\n"
      "colour, 7 with NaN or infinite pixels, 8 without error bars, 9 of one replicate, 11 with zero error "
      "bars.");
}

}  // namespace

void add_converge_command(CLI::App& app, int& exit_code) {
  CLI::App* converge = app.add_subcommand(
      "converge", "measure how noise falls with samples and time, and compare settings by it");
  auto arguments = std::make_shared<Arguments>();
  add_render_options(*converge, *arguments);
  add_expectations(*converge, *arguments);
  add_reports(*converge, *arguments);
  converge->callback([arguments, &exit_code] { exit_code = command(*arguments); });
}

}  // namespace umbral
