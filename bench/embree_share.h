// Which share of the processor's time is spent inside Embree, by sampling where the program is.
#pragma once

#include <cstdint>

namespace umbral::bench {

// Samples the program counter every millisecond of processor time while it lives (x86-64 Linux).
class EmbreeShare {
 public:
  EmbreeShare();
  ~EmbreeShare();
  EmbreeShare(const EmbreeShare&) = delete;
  EmbreeShare& operator=(const EmbreeShare&) = delete;

  double share() const;           // 0 … 1
  std::uint64_t samples() const;  // its relative error is about 1/√samples
};

}  // namespace umbral::bench
