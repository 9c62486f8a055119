// `umbral check`: every error of a scene file at once, and what is legal but doubtful.
#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include "app/arguments.h"
#include "app/commands.h"
#include "app/exit_code.h"
#include "app/load_scene.h"

namespace umbral {

void add_check_command(CLI::App& app, int& exit_code) {
  CLI::App* check = app.add_subcommand("check", "list every error and every doubt in a scene");
  auto path = std::make_shared<std::string>();
  auto options = std::make_shared<ReadOptions>();
  check->add_option("scene", *path, scene_help())->required();
  add_read_options(*check, *options);
  check->callback([path, options, &exit_code] {
    const LoadedScene loaded = load_scene(*path, *options, false);
    for (const Diagnostic& warning : loaded.file.warnings) fmt::print("{}\n", warning.text());
    const std::size_t warnings = loaded.file.warnings.size();
    fmt::print("{}: no errors, {} {}\n", *path, warnings, warnings == 1 ? "warning" : "warnings");
    exit_code = exit_success;
  });
}

}  // namespace umbral
