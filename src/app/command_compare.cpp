// `umbral compare`: whether two images are the same but for their noise.
#include <algorithm>

#include <fmt/format.h>
#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include "app/arguments.h"
#include "app/commands.h"
#include "app/compare/compare_inputs.h"
#include "app/compare/compare_report.h"
#include "app/exit_code.h"
#include "app/watched_render.h"
#include "core/parallel.h"
#include "image/atomic_file.h"

namespace umbral {
namespace {

struct Arguments {
  CompareInputs inputs;
  EqualitySettings equality{};
  std::vector<std::string> regions;
  std::string grid = "4x4", page, json;
  double exposure = 0;
  int threads = 0;
  bool quiet = false;
};

// What a grid's cells are called: A1 is at the top left, the letter is the column's.
std::vector<Region> grid_of(const std::string& text, int width, int height) {
  int columns = 0, rows = 0, used = 0;
  if (std::sscanf(text.c_str(), "%dx%d%n", &columns, &rows, &used) != 2 ||
      static_cast<std::size_t>(used) != text.size() || std::min(columns, rows) < 0 || columns > 26 ||
      rows > 99)
    refuse("--grid wants COLUMNSxROWS, up to 26x99, or 0x0 for none, not '" + text + "'");
  if (columns > width || rows > height) refuse("--grid has more cells than the image has pixels");
  if (columns * rows == 0) return {};
  std::vector<Region> cells = tiles(width, height, columns, rows);
  for (std::size_t i = 0; i < cells.size(); ++i)
    cells[i].name = fmt::format("{}{}", static_cast<char>('A' + i % static_cast<std::size_t>(columns)),
                                i / static_cast<std::size_t>(columns) + 1);
  return cells;
}

Region named_region(const std::string& text, int width, int height) {
  const std::size_t equals = text.find('=');
  Region r{text.substr(0, equals), 0, 0, 0, 0};
  int used = 0;
  const std::string numbers = equals == std::string::npos ? "" : text.substr(equals + 1);
  if (equals == 0 || std::sscanf(numbers.c_str(), "%d,%d,%d,%d%n", &r.x0, &r.y0, &r.x1, &r.y1, &used) != 4 ||
      static_cast<std::size_t>(used) != numbers.size())
    refuse("--region wants NAME=x0,y0,x1,y1 in pixels, not '" + text + "'");
  if (!(0 <= r.x0 && r.x0 < r.x1 && r.x1 <= width && 0 <= r.y0 && r.y0 < r.y1 && r.y1 <= height))
    refuse(fmt::format("--region {} holds no pixel, or reaches out of the image of {}x{} pixels", text, width,
                       height));
  return r;
}

std::vector<Region> named_regions(const Arguments& arguments, int width, int height) {
  if (arguments.regions.empty()) return grid_of(arguments.grid, width, height);
  std::vector<Region> regions;
  for (const std::string& text : arguments.regions) regions.push_back(named_region(text, width, height));
  return regions;
}

int exit_code_of(const Comparison& comparison) {
  if (!comparison.judgement) return exit_no_error_bars;
  switch (comparison.judgement->outcome) {
    case Outcome::agrees:
      return exit_success;
    case Outcome::differs:
      return exit_differ;
    case Outcome::underpowered:
    case Outcome::skewed:
      break;
  }
  return exit_not_reached;
}

std::optional<ComparedPair> read_or_render(const Arguments& arguments, const RegionsOf& regions) {
  const WatchedRender watched(arguments.quiet);
  return compared_pair(arguments.inputs, regions, watched.hooks());
}

// 16-bit numbers are rounded by up to 2⁻¹¹; a flat region may be off by that without any noise.
double resolution_of(const ComparedPair& pair, double finest) {
  return pair.a.half || pair.b.half ? std::max(finest, 0x1p-10) : finest;
}

int command(const Arguments& arguments) {
  std::optional<ThreadLimit> threads;
  if (arguments.threads > 0) threads.emplace(arguments.threads);
  for (const std::string& path : {arguments.page, arguments.json})
    if (!path.empty()) const AtomicFile probe(path);  // fails now rather than after a long render
  ComparisonSettings settings{arguments.equality, {}, static_cast<float>(arguments.exposure)};
  settings.equality.scale_floor = 1;
  const auto regions = [&](int width, int height) {
    settings.regions = named_regions(arguments, width, height);
    return regions_of(width, height, settings);
  };
  const std::optional<ComparedPair> pair = read_or_render(arguments, regions);
  if (!pair) {
    fmt::print(stderr,
               "interrupted: a comparison takes all its renders, so there is none and nothing is written\n");
    return exit_interrupted;
  }
  settings.equality.resolution = resolution_of(*pair, settings.equality.resolution);
  const Comparison comparison = compared(pair->a.image, pair->b.image, settings);
  if (!arguments.json.empty())
    write_file(arguments.json, comparison_json(comparison, *pair, settings).dump(2) + "\n");
  if (!arguments.page.empty()) write_page(arguments.page, comparison_page(comparison, *pair, settings));
  if (!arguments.quiet) fmt::print("{}", comparison_text(comparison, *pair, settings));
  return exit_code_of(comparison);
}

void add_options(CLI::App& compare, Arguments& a) {
  CompareInputs& inputs = a.inputs;
  compare.add_option("inputs", inputs.inputs,
                     "A, the reference, and B: EXRs or scenes; or one scene and its two variants");
  compare.add_option("-a", inputs.a, "EXRs of A that differ in their seeds");
  compare.add_option("-b", inputs.b, "EXRs of B that differ in their seeds");
  compare.add_option("--layer", inputs.layer, "the layer of the EXRs to compare");
  compare.add_option("--exact", inputs.exact, "take the EXR a or b for the truth, without error")
      ->check(CLI::IsMember({"a", "b"}));
  add_variant_options(compare, inputs.variants);
  add_read_options(compare, inputs.read);
  compare.add_option("--replicates", inputs.replicates, "renders of either side of a scene; default 16")
      ->check(CLI::Range(2, 1024));
  compare.add_option("--spp", inputs.spp, "samples per pixel of each of these renders")
      ->check(CLI::Range(1, 1 << 30));
  compare.add_option("--size", inputs.size, "image size of these renders, WIDTHxHEIGHT");
  compare.add_option("--seed", inputs.seed, "another seed gives independent renders")->check(whole_number());
  compare
      .add_option("--alpha", a.equality.alpha, "chance that equal images are called different; default 0.001")
      ->check(CLI::Range(1e-12, 0.5));
  compare
      .add_option("--image-mde", a.equality.image_mde,
                  "relative difference of the image's mean that must not go unseen; default 0.005")
      ->check(number_above(0));
  compare
      .add_option("--tile-mde", a.equality.tile_mde,
                  "that of a tile, relative to its mean or the image's; default 0.03")
      ->check(number_above(0));
  compare.add_option("--grid", a.grid, "regions to tell the change of; default 4x4, none 0x0");
  compare.add_option("--region", a.regions, "such a region, instead: NAME=x0,y0,x1,y1; may be repeated")
      ->take_all()
      ->allow_extra_args(false);
  compare.add_option("--exposure", a.exposure, "stops, of what FLIP and the page show")
      ->check(number_above(-infinity));
  compare.add_option("-o,--output", a.page, "an HTML page to write, which holds all it shows");
  compare.add_option("--json", a.json, "a file to write the numbers to");
  compare.add_option("--threads", a.threads, "default: all")->check(CLI::Range(1, 4096));
  compare.add_flag("--quiet", a.quiet, "no progress, no text: the exit code tells");
  compare.footer(
      "Exit code: 0 equal within noise, 1 differ, 4 not enough samples to tell. Not judged: 2 bad arguments "
      "or "
      "file, 3 unwritable output, 5 sizes or windows differ, 6 no colour in a file, 7 NaN or infinite "
      "pixels, "
      "8 error unknown, 9 one replicate only, 10 same seed or same image twice, 11 a reference without any "
      "error.");
}

}  // namespace

void add_compare_command(CLI::App& app, int& exit_code) {
  CLI::App* compare =
      app.add_subcommand("compare", "tell whether two images are the same but for their noise");
  auto arguments = std::make_shared<Arguments>();
  add_options(*compare, *arguments);
  compare->callback([arguments, &exit_code] { exit_code = command(*arguments); });
}

}  // namespace umbral
