// Words of the command line that several commands understand alike.
#pragma once

#include <string>

#include "formats/read_options.h"
#include "scene/settings.h"

namespace CLI {
class App;
class Validator;
}  // namespace CLI

namespace umbral {

/// Refuses what the command line asks for: throws SceneError without a place.
[[noreturn]] void refuse(const std::string& message);

/// A share above 0 out of "1%" or "0.01"; `option` is for the message. Throws SceneError.
double parsed_share(const std::string& text, const std::string& option);

/// Width and height out of "WIDTHxHEIGHT". Throws SceneError.
void apply_size(const std::string& text, FilmSettings& film);

/// A finite number above `low`. CLI11's own checks accept NaN, and print a limit of 300 digits.
CLI::Validator number_above(double low);

/// CLI11 alone would read -1 as 2⁶⁴ − 1.
CLI::Validator whole_number();

/// What files can be rendered, for the help of commands.
std::string scene_help();

/// --lenient and what else the readers of scene files take.
void add_read_options(CLI::App& command, ReadOptions& options);

}  // namespace umbral
