// `umbral render`: from a scene file to an EXR, a PNG and one line about both.
#include <algorithm>
#include <filesystem>

#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include "app/arguments.h"
#include "app/commands.h"
#include "app/exit_code.h"
#include "app/load_scene.h"
#include "app/render_report.h"
#include "app/replay.h"
#include "app/view_arguments.h"
#include "app/watched_render.h"
#include "core/names.h"
#include "core/parallel.h"
#include "image/atomic_file.h"
#include "image/film_file.h"
#include "image/png.h"

namespace umbral {
namespace {

// The command line as it was given; what was not given is empty and leaves the scene file's word.
struct Arguments {
  std::string scene, output, integrator, size, sampler;
  std::optional<int> spp, replicates;
  std::optional<std::uint64_t> seed, sample;
  int threads = 0;
  std::vector<int> crop, pixel;
  std::optional<double> seconds;
  std::string target_error;
  ViewArguments view;
  double exposure = 0;
  ReadOptions read;
  bool quiet = false, statistics = false, json = false, layers = false, auxiliary = false,
       pooled_error = false, stop_at_rejected = false;
};

void apply_sampler(const std::string& name, SamplingSettings& sampling) {
  const std::vector<std::string>& names = sampler_names();
  const auto found = std::find(names.begin(), names.end(), name);
  if (found == names.end()) refuse("there is no sampler '" + name + "'" + suggestion(name, names));
  sampling.sampler = static_cast<SamplerKind>(found - names.begin());
}

void require_pixel(const FilmSettings& film, int x, int y, const char* option) {
  if (x < 0 || y < 0 || x >= film.width || y >= film.height)
    refuse(
        fmt::format("{} {},{} is outside the image of {}x{} pixels", option, x, y, film.width, film.height));
}

RenderOptions render_options(const Arguments& arguments, const SceneFile& file) {
  RenderOptions options;
  options.film = file.film;
  options.sampling = file.sampling;
  if (!arguments.size.empty()) apply_size(arguments.size, options.film);
  if (arguments.spp) options.sampling.spp = *arguments.spp;
  if (arguments.replicates) options.sampling.replicates = *arguments.replicates;
  if (arguments.seed) options.sampling.seed = *arguments.seed;
  if (!arguments.sampler.empty()) apply_sampler(arguments.sampler, options.sampling);
  if (arguments.seconds) options.seconds = *arguments.seconds;
  if (!arguments.target_error.empty())
    options.relative_error = parsed_share(arguments.target_error, "--target-error");
  // The file's spp is a default; a rule from the command line takes its place unless --spp stands beside it.
  options.spp_bounds = arguments.spp || (!arguments.seconds && arguments.target_error.empty());
  if (options.relative_error > 0 && replicate_count(options) < 2)
    refuse("--target-error needs an error bar, and that two replicates and two samples at least");
  options.layers = arguments.layers;
  options.auxiliary = arguments.auxiliary;
  options.stop_at_rejected = arguments.stop_at_rejected;
  if (!arguments.crop.empty()) {
    const std::vector<int>& c = arguments.crop;
    if (c[0] >= c[2] || c[1] >= c[3]) refuse("--crop wants x0,y0,x1,y1 with x0 < x1 and y0 < y1");
    require_pixel(options.film, c[0], c[1], "--crop");
    require_pixel(options.film, c[2] - 1, c[3] - 1, "--crop");
    options.crop = Crop{c[0], c[1], c[2], c[3]};
  }
  return options;
}

// Where the EXR goes: -o as it was given, or the scene's name beside the caller.
std::filesystem::path output_path(const Arguments& arguments) {
  std::filesystem::path path = arguments.output;
  if (path.empty()) path = std::filesystem::path(arguments.scene).filename();
  return path.replace_extension(".exr");
}

std::string chosen_integrator(const Arguments& arguments, const LoadedScene& loaded) {
  if (arguments.integrator.empty()) return loaded.file.integrator;
  if (loaded.integrators.count(arguments.integrator) > 0) return arguments.integrator;
  std::vector<std::string> kinds;
  for (const auto& [kind, integrator] : loaded.integrators) kinds.push_back(kind);
  refuse("there is no integrator '" + arguments.integrator + "'" + suggestion(arguments.integrator, kinds));
}

RenderResult run(const Scene& scene, Integrator& integrator, const RenderOptions& options, bool quiet) {
  const WatchedRender watched(quiet, options.relative_error);
  return render(scene, integrator, options, watched.hooks());
}

// Writes both files and tells about them.
void write_and_tell(const Arguments& arguments, const RenderJob& job, const RenderResult& result,
                    const Scene& scene) {
  const std::filesystem::path exr = output_path(arguments);
  std::filesystem::path png = exr;
  png.replace_extension(".png");
  FilmImage image = film_image(*result.film, provenance(job, result, scene));
  image.with_pooled_error = arguments.pooled_error;
  write_film(exr.string(), image);
  write_png(png.string(), image.layout.crop_width(), image.layout.crop_height(), image.colours(),
            static_cast<float>(arguments.exposure));
  if (const std::string rejected = rejected_text(*result.film, job); !rejected.empty())
    fmt::print(stderr, "{}\n", rejected);
  if (arguments.json) {
    fmt::print("{}\n", summary_json(image, scene, result.target, exr.string(), png.string()));
    return;
  }
  if (arguments.quiet) return;
  fmt::print("{} and {}: {}\n", exr.string(), png.string(), summary_line(image, scene));
  if (arguments.statistics) fmt::print("{}\n", statistics_text(image, scene));
}

int exit_code_of(const RenderResult& result, const RenderOptions& options) {
  if (options.stop_at_rejected && result.film->rejected() > 0) return exit_differ;
  if (result.stop_reason == "interrupted") return exit_interrupted;
  if (options.relative_error > 0 && !result.target.reached) return exit_not_reached;
  return exit_success;
}

std::vector<std::string> bias_notes(const Integrator& integrator, const SceneDescription& scene) {
  std::vector<std::string> notes = integrator.bias_notes();
  const auto is_blurred = [](const Texture& texture) {
    const auto* image = std::get_if<ImageTexture>(&texture.kind);
    return image && image->filter == TextureFilter::mip;
  };
  if (std::any_of(scene.textures.begin(), scene.textures.end(), is_blurred))
    notes.emplace_back("textures of filter mip are blurred to the width of a path");
  return notes;
}

int command(const Arguments& arguments) {
  std::optional<ThreadLimit> threads;
  if (arguments.threads > 0) threads.emplace(arguments.threads);
  const bool without_progress = arguments.quiet || arguments.json;
  LoadedScene loaded = load_scene(arguments.scene, arguments.read, without_progress);
  apply_view(arguments.view, loaded.file);
  const std::string kind = chosen_integrator(arguments, loaded);
  Integrator& integrator = loaded.integrator(kind);
  const RenderJob job{arguments.scene,
                      kind,
                      integrator_text(kind, integrator),
                      bias_notes(integrator, loaded.file.scene),
                      loaded.file.hash,
                      render_options(arguments, loaded.file),
                      loaded.file.left_out,
                      loaded.file.approximated};
  if (!arguments.quiet) print_warnings(loaded.file);
  const Scene scene = built_scene(std::move(loaded.file.scene), without_progress);

  if (!arguments.pixel.empty()) {
    const int x = arguments.pixel[0], y = arguments.pixel[1];
    require_pixel(job.options.film, x, y, "--pixel");
    fmt::print("{}\n", arguments.sample
                           ? replayed_sample(scene, integrator, job.options, x, y, *arguments.sample)
                           : replayed_pixel(scene, integrator, job.options, x, y));
    return exit_success;
  }
  if (arguments.sample) refuse("--sample needs --pixel x,y");
  { const AtomicFile probe(output_path(arguments).string()); }  // fails now rather than after hours
  const RenderResult result = run(scene, integrator, job.options, without_progress);
  write_and_tell(arguments, job, result, scene);
  return exit_code_of(result, job.options);
}

void add_options(CLI::App& render, Arguments& a) {
  render.add_option("scene", a.scene, scene_help())->required();
  render.add_option("-o,--output", a.output,
                    "the EXR to write, a PNG beside it; default: the scene's name, here");
  render.add_option("--integrator", a.integrator, "how light is gathered, instead of what the scene says");
  render.add_option("--spp", a.spp, "samples per pixel")->check(CLI::Range(1, 1 << 30));
  render.add_option("--time", a.seconds, "seconds to sample for")->check(number_above(0));
  render.add_option(
      "--target-error", a.target_error,
      "stop when the RMS standard error of a pixel is below this share of the image's mean, such as "
      "1%, with 95 % confidence");
  render.add_option("--replicates", a.replicates, "independent parts of each pixel's samples")
      ->check(CLI::Range(1, 1024));
  render.add_option("--sampler", a.sampler, "independent or sobol");
  render.add_option("--seed", a.seed, "another seed gives an independent image")->check(whole_number());
  render.add_option("--size", a.size, "image size, WIDTHxHEIGHT");
  render.add_option("--crop", a.crop, "part of the image: x0,y0,x1,y1")->delimiter(',')->expected(4);
  render.add_option("--threads", a.threads, "default: all")->check(CLI::Range(1, 4096));
  render.add_option("--env", a.read.environment, "a latitude-longitude image as the environment");
  add_read_options(render, a.read);
  add_view_options(render, a.view);
  render.add_option("--exposure", a.exposure, "stops, of the PNG alone")->check(number_above(-infinity));
  render.add_flag("--layers", a.layers, "the integrator's layers as channels of their own");
  render.add_flag("--aux", a.auxiliary, "albedo, N and Z as channels of their own");
  render.add_flag("--pooled-error", a.pooled_error,
                  "stderrPooled as channels of their own: errors pooled over 5x5 pixels");
  render.add_flag("--stop-at-rejected", a.stop_at_rejected,
                  "for hunting: end at the first sample that is not finite or is negative, exit code 1");
  render.add_flag("--quiet", a.quiet, "no progress, no summary");
  render.add_flag("--stats", a.statistics, "more about speed and memory");
  render.add_flag("--json", a.json, "the summary as JSON on standard output");
  render.add_option("--pixel", a.pixel, "no image: tells of this pixel, x,y")->delimiter(',')->expected(2);
  render.add_option("--sample", a.sample, "with --pixel: replays this sample of it")->check(whole_number());
}

}  // namespace

void add_render_command(CLI::App& app, int& exit_code) {
  CLI::App* render = app.add_subcommand("render", "render a scene into an EXR with error bars and a PNG");
  auto arguments = std::make_shared<Arguments>();
  add_options(*render, *arguments);
  render->callback([arguments, &exit_code] { exit_code = command(*arguments); });
}

}  // namespace umbral
