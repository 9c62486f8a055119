// HugePageAllocator: large arrays that are read at random, on pages of 2 MiB where the system has them.
#pragma once

#include <cstddef>
#include <new>

#if defined(__linux__)
#include <sys/mman.h>
#endif

namespace umbral {

// For std::vector. A look-up at random in an array of many megabytes misses the table of 4 KiB pages, and
// waits for the page walk as long as for the texel; arrays of at least one huge page are aligned to it and
// say so to the kernel.
template <class T>
struct HugePageAllocator {
  using value_type = T;
  static constexpr std::size_t huge_page = std::size_t{1} << 21;

  HugePageAllocator() = default;
  template <class U>
  HugePageAllocator(const HugePageAllocator<U>&) {}

  T* allocate(std::size_t n) {
    const std::size_t bytes = n * sizeof(T);
    void* const memory = ::operator new(bytes, alignment(bytes));
#if defined(__linux__)
    if (bytes >= huge_page) ::madvise(memory, bytes, MADV_HUGEPAGE);  // a wish: failure changes nothing
#endif
    return static_cast<T*>(memory);
  }

  void deallocate(T* memory, std::size_t n) { ::operator delete(memory, alignment(n * sizeof(T))); }

  bool operator==(const HugePageAllocator&) const = default;

 private:
  static constexpr std::align_val_t alignment(std::size_t bytes) {
    return std::align_val_t{bytes >= huge_page ? huge_page : std::size_t{64}};
  }
};

}  // namespace umbral
