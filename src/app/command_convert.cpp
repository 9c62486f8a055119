// `umbral convert`: a scene of any format in our own, to be carried on by hand.
#include <filesystem>

#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include "app/arguments.h"
#include "app/commands.h"
#include "app/convert/scene_writer.h"
#include "app/exit_code.h"

namespace umbral {

void add_convert_command(CLI::App& app, int& exit_code) {
  CLI::App* convert = app.add_subcommand("convert", "write a scene of any format as a .toml scene");
  auto from = std::make_shared<std::string>(), to = std::make_shared<std::string>();
  auto options = std::make_shared<ReadOptions>();
  convert->add_option("scene", *from, scene_help())->required();
  convert
      ->add_option("result", *to,
                   "the .toml scene to write; its meshes and images come into a folder beside it")
      ->required();
  add_read_options(*convert, *options);
  convert->callback([from, to, options, &exit_code] {
    const std::filesystem::path path = *to;
    if (path.extension() != ".toml") refuse("the name of the result must end in .toml");
    std::error_code absent;
    if (std::filesystem::equivalent(*from, path, absent))
      refuse("the result would take the place of the scene");
    const LoadedScene loaded = load_scene(*from, *options, false);
    for (const Diagnostic& warning : loaded.file.warnings) fmt::print(stderr, "{}\n", warning.text());
    write_scene(loaded, *from, path);
    fmt::print("{}: written\n", path.string());
    exit_code = exit_success;
  });
}

}  // namespace umbral
