// Numbers out of words.
#include "app/arguments.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>

#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include "core/error.h"
#include "formats/model_file.h"

namespace umbral {

void refuse(const std::string& message) { throw SceneError(Where{}, message); }

double parsed_share(const std::string& text, const std::string& option) {
  std::size_t end = 0;
  double value = 0;
  try {
    value = std::stod(text, &end);
  } catch (const std::exception&) {
    end = 0;
  }
  const std::string rest = text.substr(end);
  if (end == 0 || !(value > 0) || !std::isfinite(value) || (!rest.empty() && rest != "%"))
    refuse(option + " wants a share above 0, such as 1% or 0.01, not '" + text + "'");
  return rest.empty() ? value : value / 100;
}

void apply_size(const std::string& text, FilmSettings& film) {
  int width = 0, height = 0, used = 0;
  if (std::sscanf(text.c_str(), "%dx%d%n", &width, &height, &used) != 2 ||
      static_cast<std::size_t>(used) != text.size() || std::min(width, height) < 1 ||
      std::max(width, height) > 65536)
    refuse("--size wants WIDTHxHEIGHT in pixels, 1 … 65536, not '" + text + "'");
  film.width = width;
  film.height = height;
}

CLI::Validator number_above(double low) {
  return {[low](std::string& text) {
            char* end = nullptr;
            const double x = std::strtod(text.c_str(), &end);
            if (end != text.c_str() && *end == 0 && std::isfinite(x) && x > low) return std::string();
            return fmt::format("wants a number{}, not '{}'",
                               std::isfinite(low) ? fmt::format(" above {}", low) : "", text);
          },
          ""};
}

CLI::Validator whole_number() {
  return {[](std::string& text) {
            const bool whole = !text.empty() && text.find_first_not_of("0123456789") == std::string::npos;
            return whole ? std::string() : fmt::format("wants a whole number, 0 or above, not '{}'", text);
          },
          ""};
}

std::string scene_help() { return "a .toml, .pbrt or Mitsuba .xml scene, or a model: " + model_endings(); }

void add_read_options(CLI::App& command, ReadOptions& options) {
  command
      .add_option(
          "--texture-memory", options.texture_memory,
          "what the images of all textures may take, such as 2G or 500M; others stay in their files and are "
          "read tile by tile; default: 4G")
      ->transform(CLI::AsSizeValue(false));
  command.add_flag(
      "--lenient", options.lenient,
      "leave out what a file of another renderer asks for and umbral lacks; told in the image's header");
  command
      .add_option_function<std::vector<std::string>>(
          "-D",
          [&options](const std::vector<std::string>& definitions) {
            for (const std::string& text : definitions) {
              const std::size_t equals = text.find('=');
              if (equals == 0 || equals == std::string::npos)
                refuse("-D wants name=value, not '" + text + "'");
              options.definitions[text.substr(0, equals)] = text.substr(equals + 1);
            }
          },
          "name=value: of a parameter that a Mitsuba file declares with <default>")
      ->type_name("NAME=VALUE");
}

}  // namespace umbral
