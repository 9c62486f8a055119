// What a caller asks of the readers of scene files.
#pragma once

#include <map>
#include <string>

namespace umbral {

struct ReadOptions {
  // What a file asks for and umbral lacks is left out with a warning, instead of being an error.
  bool lenient = false;
  // Values for the parameters that a Mitsuba file declares with <default>.
  std::map<std::string, std::string> definitions;
};

}  // namespace umbral
