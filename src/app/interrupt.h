// Ctrl-C as a flag.
#pragma once

#include <atomic>

namespace umbral {

// While it lives, the first SIGINT or SIGTERM sets flag(); one that comes more than a second later ends the program at once.
// Once there was a first, that stays so after its life too, until what there is is written.
class InterruptGuard {
 public:
  InterruptGuard();
  ~InterruptGuard();
  InterruptGuard(const InterruptGuard&) = delete;
  InterruptGuard& operator=(const InterruptGuard&) = delete;

  const std::atomic<bool>& flag() const;
};

}  // namespace umbral
