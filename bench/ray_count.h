// How many rays a render traces. The linker puts the counter in front of Embree's functions (see CMakeLists.txt), so
// that the renderer itself has no instruction of it.
#pragma once

#include <cstdint>

namespace umbral::bench {

// Counts from now on, if `on`, and starts from 0.
void count_rays(bool on);

// Of all threads, since count_rays(true).
std::uint64_t rays_counted();

}  // namespace umbral::bench
