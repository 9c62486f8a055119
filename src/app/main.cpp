// The program: picks the command and turns every error into one message and an exit code.
#include <algorithm>
#include <cstdio>
#include <exception>

#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include "analysis/estimated_file.h"
#include "app/arguments.h"
#include "app/commands.h"
#include "app/exit_code.h"
#include "core/error.h"
#include "core/names.h"
#include "image/film_image.h"
#include "umbral_version.h"

namespace {

int fail(int exit_code, const char* message) {
  fmt::print(stderr, "umbral: {}\n", message);
  return exit_code;
}

int exit_code_of(umbral::UnfitReason reason) {
  switch (reason) {
    case umbral::UnfitReason::size:
      return umbral::exit_other_size;
    case umbral::UnfitReason::channels:
      return umbral::exit_no_channels;
    case umbral::UnfitReason::not_finite:
      return umbral::exit_not_finite;
    case umbral::UnfitReason::no_error:
      return umbral::exit_no_error_bars;
    case umbral::UnfitReason::one_replicate:
      return umbral::exit_one_replicate;
    case umbral::UnfitReason::not_independent:
      return umbral::exit_not_independent;
    case umbral::UnfitReason::no_variance:
      return umbral::exit_no_variance;
  }
  return umbral::exit_failure;
}

[[noreturn]] void refuse_name(const std::string& kind, const std::string& word,
                              const std::vector<std::string>& names) {
  umbral::refuse("there is no " + kind + " '" + word + "'" + umbral::suggestion(word, names));
}

// CLI11 would only say that a command is required.
void refuse_unknown_command(const CLI::App& app, const std::string& word) {
  std::vector<std::string> names;
  for (const CLI::App* command : app.get_subcommands({})) names.push_back(command->get_name());
  if (!word.starts_with('-') && std::find(names.begin(), names.end(), word) == names.end())
    refuse_name("command", word, names);
}

// What CLI11 calls not expected: options get the nearest name of the command that they were given to.
void refuse_unknown_option(const CLI::App& app) {
  const std::vector<CLI::App*> chosen = app.get_subcommands();
  const CLI::App& command = chosen.empty() ? app : *chosen.front();
  std::vector<std::string> names;
  for (const CLI::Option* option : command.get_options())
    for (const std::string& name : option->get_lnames()) names.push_back("--" + name);
  for (const std::string& word : command.remaining())
    if (word.starts_with("--")) refuse_name("option", word.substr(0, word.find('=')), names);
}

// CLI11 would take the option that follows for the value that was forgotten.
void refuse_options_as_values(CLI::App& app) {
  const CLI::Validator no_option(
      [](std::string& text) {
        return text.starts_with("--") ? "wants a value before '" + text + "'" : std::string();
      },
      "");
  for (CLI::App* command : app.get_subcommands({}))
    for (CLI::Option* option : command->get_options()) option->check(no_option);
}

int run(int argc, char** argv) {
  CLI::App app{"umbral: a Monte Carlo path tracer that knows its own error", "umbral"};
  app.set_version_flag("--version", umbral::version);
  app.require_subcommand(1);
  app.footer("umbral COMMAND --help explains a command, umbral help what a scene file may hold.");
  int exit_code = umbral::exit_success;
  umbral::add_render_command(app, exit_code);
  umbral::add_check_command(app, exit_code);
  umbral::add_convert_command(app, exit_code);
  umbral::add_info_command(app, exit_code);
  umbral::add_merge_command(app, exit_code);
  umbral::add_compare_command(app, exit_code);
  umbral::add_converge_command(app, exit_code);
  umbral::add_help_command(app, exit_code);
  refuse_options_as_values(app);
  if (argc < 2) {
    fmt::print(stderr, "{}", app.help());
    return umbral::exit_bad_input;
  }
  refuse_unknown_command(app, argv[1]);
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    refuse_unknown_option(app);
    return app.exit(error) == 0 ? umbral::exit_success : umbral::exit_bad_input;
  }
  return exit_code;
}

}  // namespace

int main(int argc, char** argv) {
  try {
    return run(argc, argv);
  } catch (const umbral::SceneError& error) {
    fmt::print(stderr, "{}\n", error.what());
    return umbral::exit_bad_input;
  } catch (const umbral::CombineError& error) {
    return fail(umbral::exit_bad_input, error.what());
  } catch (const umbral::UnfitImage& error) {
    return fail(exit_code_of(error.reason()), error.what());
  } catch (const umbral::OutputError& error) {
    return fail(umbral::exit_bad_output, error.what());
  } catch (const std::bad_alloc&) {
    return fail(umbral::exit_failure, "out of memory");
  } catch (const std::exception& error) {
    return fail(umbral::exit_failure, error.what());
  }
}
