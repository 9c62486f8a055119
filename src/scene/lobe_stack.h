// Room for the lobes at one point of a surface: that of its material and those that it is made of.
#pragma once

#include <cassert>
#include <cstddef>
#include <new>

#include "bsdf/lobes.h"

namespace umbral {

// Nothing is written before the first lobe is: a point of a material without textures costs nothing.
class LobeStack {
 public:
  // Of one material; readers refuse more.
  static constexpr int most = 16;

  void clear() { count_ = 0; }
  // Its place does not change until clear().
  Lobes& push(const Lobes& lobe) {
    assert(count_ < most);
    return *new (room_ + sizeof(Lobes) * static_cast<std::size_t>(count_++)) Lobes(lobe);
  }

 private:
  static_assert(std::is_trivially_destructible_v<Lobes>);
  alignas(Lobes) std::byte room_[sizeof(Lobes) * most];
  int count_ = 0;
};

}  // namespace umbral
