// Ctrl-C as a flag.
#pragma once

#include <atomic>

namespace umbral {

// While it lives, the first SIGINT or SIGTERM sets flag(); a second one ends the program at once.
class InterruptGuard {
 public:
  InterruptGuard();
  ~InterruptGuard();
  InterruptGuard(const InterruptGuard&) = delete;
  InterruptGuard& operator=(const InterruptGuard&) = delete;

  const std::atomic<bool>& flag() const;
};

}  // namespace umbral
