// Processor time, which other programs lengthen less than they do wall-clock time.
#pragma once

#include <sys/resource.h>

namespace umbral::bench {

// Of all threads of this process so far.
inline double cpu_seconds() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return static_cast<double>(usage.ru_utime.tv_sec + usage.ru_stime.tv_sec) +
         1e-6 * static_cast<double>(usage.ru_utime.tv_usec + usage.ru_stime.tv_usec);
}

}  // namespace umbral::bench
