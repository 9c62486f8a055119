// ProgressLine: one line on stderr that is written anew in place, or line after line where there is no terminal.
#pragma once

#include <string>

namespace umbral {

class ProgressLine {
 public:
  // `patience`: seconds before the first line on a terminal. Elsewhere they are 2: what is short needs no lines.
  explicit ProgressLine(double patience);

  bool is_terminal() const { return terminal_; }
  // Whether it is time for a line; ever more rarely, as what takes long needs less attention. Seconds from the start.
  bool is_due(double elapsed);
  void show(const std::string& text);
  // Takes it off the terminal.
  void clear();

 private:
  bool terminal_, shown_ = false;
  double next_;  // seconds from the start
};

// "12.3 s", "2 min 05 s", "1 h 02 min".
std::string duration_text(double seconds);

}  // namespace umbral
