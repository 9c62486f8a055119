// `umbral merge`: renders of one scene with different seeds become one.
#include <filesystem>

#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include "app/commands.h"
#include "app/exit_code.h"
#include "image/film_file.h"
#include "image/png.h"

namespace umbral {
namespace {

void merge(const std::vector<std::string>& inputs, const std::string& output) {
  FilmImage image = read_film(inputs.front());
  for (std::size_t i = 1; i < inputs.size(); ++i) image = combined(image, read_film(inputs[i]));
  write_film(output, image);
  const std::string png = std::filesystem::path(output).replace_extension(".png").string();
  write_png(png, image.layout.crop_width(), image.layout.crop_height(), image.colours());
  fmt::print("{} and {}: {:g} spp; error {:.3g} %; mean {:.6g} ± {:.2g} (95 %)\n", output, png,
             image.samples_per_pixel(), 100 * image.error.relative(), image.error.mean,
             image.error.half_width());
}

}  // namespace

void add_merge_command(CLI::App& app, int& exit_code) {
  CLI::App* command = app.add_subcommand("merge", "join renders of one scene that differ in their seeds");
  struct Arguments {
    std::vector<std::string> inputs;
    std::string output;
  };
  auto arguments = std::make_shared<Arguments>();
  command->add_option("files", arguments->inputs, "EXRs that umbral wrote")->required()->expected(2, 1 << 20);
  command->add_option("-o,--output", arguments->output, "the EXR to write, a PNG beside it")->required();
  command->callback([arguments, &exit_code] {
    merge(arguments->inputs, arguments->output);
    exit_code = exit_success;
  });
}

}  // namespace umbral
