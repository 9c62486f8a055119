// The parallel loop and how many threads it may use.
#pragma once

#include <cstddef>
#include <functional>
#include <memory>

namespace umbral {

// Number of processors that this process may use; at least 1.
int available_threads();

// Bounds the threads of everything that runs in parallel while it lives.
class ThreadLimit {
 public:
  explicit ThreadLimit(int threads);  // ≥ 1
  ~ThreadLimit();
  ThreadLimit(const ThreadLimit&) = delete;
  ThreadLimit& operator=(const ThreadLimit&) = delete;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

// Calls body(0) … body(count−1) in any order, on any threads. The first exception thrown is rethrown here after
// every running call has ended.
void parallel_for(std::size_t count, const std::function<void(std::size_t)>& body);

}  // namespace umbral
