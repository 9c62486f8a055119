// What the program's exit code says.
#pragma once

namespace umbral {

enum ExitCode {
  exit_success = 0,           // of compare: equal within noise
  exit_differ = 1,            // of compare; of render --stop-at-rejected, there was one
  exit_bad_input = 2,         // arguments, scene or other input files
  exit_bad_output = 3,        // a file could not be written
  exit_not_reached = 4,       // a target error was not reached, or compare needs more samples to tell
  exit_other_size = 5,        // images of different sizes or crop windows
  exit_no_channels = 6,       // an image lacks its colour
  exit_not_finite = 7,        // NaN or infinite pixels
  exit_no_error_bars = 8,     // nothing is known of an image's error: it cannot be judged
  exit_one_replicate = 9,     // an image has one replicate, so its error bars are unknown
  exit_not_independent = 10,  // images made of the same random numbers
  exit_no_variance = 11,      // a reference that claims to be exact
  exit_failure = 70,          // anything unforeseen
  exit_interrupted = 130      // by Ctrl-C; what there was has been written
};

}  // namespace umbral
