// `umbral info`: what an EXR of ours says of itself.
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <CLI/CLI.hpp>

#include "app/commands.h"
#include "app/exit_code.h"
#include "app/render_report.h"
#include "image/film_file.h"

namespace umbral {
namespace {

void print_line(const char* name, const std::string& value) {
  if (!value.empty()) fmt::print("  {:<12} {}\n", name, value);
}

void print_info(const std::string& path) {
  const FilmImage image = read_film(path);
  const Provenance& p = image.provenance;
  const ImageError& error = image.error;
  fmt::print("{}\n", path);
  print_line("size", fmt::format("{} x {}", image.layout.width, image.layout.height));
  if (image.layout.crop_width() != image.layout.width || image.layout.crop_height() != image.layout.height)
    print_line("crop", fmt::format("{},{},{},{}", image.layout.x0, image.layout.y0, image.layout.x1,
                                   image.layout.y1));
  print_line("mean", fmt::format("{:.6g} ± {:.2g} (95 % confidence, {:.3g} degrees of freedom)", error.mean,
                                 error.half_width(), error.degrees_of_freedom));
  print_line("error",
             fmt::format("{:.3g} % (RMS standard error of a pixel over the mean)", 100 * error.relative()));
  const std::string tails = tails_text(image);
  print_line("tails",
             tails.empty() ? fmt::format("light (index {:.2f}), no fireflies", image.tail_index) : tails);
  print_line("samples",
             fmt::format("{:g} per pixel in {} replicates, {:g} rejected", image.samples_per_pixel(),
                         image.layout.replicates, image.samples_rejected));
  print_line("layers", fmt::format("{}", fmt::join(image.layout.layers, ", ")));
  print_line("scene", fmt::format("{} (hash {})", p.scene, p.scene_hash));
  print_line("integrator", p.integrator);
  print_line("bias", p.bias_notes.empty() ? "none" : fmt::format("{}", fmt::join(p.bias_notes, "; ")));
  print_line("sampler", fmt::format("{}, seed {}", p.sampler, fmt::join(p.seeds, ", ")));
  print_line("filter", p.filter);
  print_line("time", fmt::format("{:.3g} s, stopped by {}", p.render_seconds, p.stop_reason));
  print_line("version", p.version);
  for (const auto& [name, value] : p.extra) print_line(name.c_str(), value);
}

}  // namespace

void add_info_command(CLI::App& app, int& exit_code) {
  CLI::App* info = app.add_subcommand("info", "tell how exact an EXR is and how it was made");
  auto path = std::make_shared<std::string>();
  info->add_option("file", *path, "an EXR that umbral wrote")->required();
  info->callback([path, &exit_code] {
    print_info(*path);
    exit_code = exit_success;
  });
}

}  // namespace umbral
