// Says which umbral this is.
#pragma once

namespace umbral {

/// Version of the program: "0.1.0", followed by "+" and what `git describe` says where git is at hand.
extern const char* const version;

}  // namespace umbral
