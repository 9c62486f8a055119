// What the program's exit code says.
#pragma once

namespace umbral {

enum ExitCode {
  exit_success = 0,
  exit_failure = 1,       // anything unforeseen
  exit_bad_input = 2,     // arguments, scene or other input files
  exit_bad_output = 3,    // a file could not be written
  exit_not_reached = 4,   // --target-error was not reached with the samples and time allowed
  exit_interrupted = 130  // by Ctrl-C; what there was has been written
};

}  // namespace umbral
